// SPDX-License-Identifier: BSD-3-Clause
#include "edits/links.h"

#include <filesystem>
#include <vector>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;

std::map<std::string, std::string> links_below(const std::string& folder) {
  std::map<std::string, std::string> links;
  std::error_code failed, ignored;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(folder, options, failed), end; !failed && at != end;
       at.increment(failed)) {
    if (at->is_symlink(ignored))
      links.emplace(at->path().string(), canonical_path(at->path().string()));
    else if (at->path().filename().string().front() == '.')
      at.disable_recursion_pending();
  }
  return links;
}

std::set<std::string> with_links(const std::string& folder, const std::string& package_dir) {
  const std::string package = canonical_path(package_dir);
  std::vector<std::string> open = {canonical_path(folder)};
  std::set<std::string> found;
  while (!open.empty()) {
    const std::string place = open.back();
    open.pop_back();
    const bool is_own = place == package || is_below(place, package);
    if (!found.insert(place).second || !is_own) continue;
    for (const auto& [link, target] : links_below(place))
      if (target == package || is_below(target, package)) open.push_back(target);
  }
  return found;
}

}  // namespace tzc::rewriter
