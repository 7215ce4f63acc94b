// SPDX-License-Identifier: BSD-3-Clause
#include "paper/publication.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>

namespace tzc {
namespace bench {
namespace {

namespace fs = std::filesystem;

bool is_shown(const fs::path& file) {
  constexpr const char* endings[] = {".md", ".csv", ".svg", ".png"};
  return file.filename() == "run.json" ||
         std::find(std::begin(endings), std::end(endings), file.extension()) != std::end(endings);
}

}  // namespace

void publish(const Store& store, const std::string& folder) {
  try {
    fs::create_directories(folder);
    for (const auto& entry : fs::directory_iterator(store.path_of("")))
      if (entry.is_regular_file() && is_shown(entry.path()))
        fs::copy_file(entry.path(), folder / entry.path().filename(), fs::copy_options::overwrite_existing);
  } catch (const fs::filesystem_error& error) {
    throw StoreError(fmt::format("cannot publish into {}: {}", folder, error.code().message()));
  }
}

}  // namespace bench
}  // namespace tzc
