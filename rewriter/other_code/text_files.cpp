// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/text_files.h"

#include <algorithm>
#include <filesystem>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;

bool TextFiles::is_left_out(const std::string& folder) const {
  return std::find(without_.begin(), without_.end(), folder) != without_.end();
}

void TextFiles::walk(const std::string& folder) {
  std::error_code failed;
  const fs::path here = fs::canonical(folder, failed);
  if (failed || is_left_out(here) || !seen_.insert(here).second) return;
  // An in-source build shares its folder with the sources.
  const bool is_built_in = fs::exists(here / "CMakeCache.txt", failed);
  const bool has_sources =
      fs::exists(here / "package.xml", failed) || fs::exists(here / "CMakeLists.txt", failed);
  if (is_built_in && !has_sources) return;
  for (const auto& entry : fs::directory_iterator(here, failed)) {
    const std::string name = entry.path().filename();
    if (name.front() == '.') continue;
    std::error_code ignored;
    if (entry.is_directory(ignored))
      walk(entry.path());
    else if ((!is_wanted_ || is_wanted_(name)) && is_text_file(entry.path()))
      visit_(entry.path());
  }
}

}  // namespace tzc::rewriter
