// SPDX-License-Identifier: BSD-3-Clause
#include "tool/message_folders.h"

#include <utility>
#include <vector>

#include "buildfiles/cmake_values.h"
#include "edits/files.h"
#include "proof/cmake_cache.h"
#include "tool/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// What genmsg says of a package in a devel space (pkg-msg-paths.cmake.develspace.in), whose messages stay with its
/// sources; those of its actions are made in the devel space. Of one that is installed, it says nothing that names a folder.
std::set<std::string> named_by_genmsg(const fs::path& share, const std::string& package) {
  const fs::path file = share / package / "cmake" / (package + "-msg-paths.cmake");
  const Expected<std::string> content = read_file(file);
  if (!content) return {};
  const Expected<std::vector<CmakeCommand>> commands = parse_cmake(*content, file);
  if (!commands) return {};
  CmakeValues values;
  for (const CmakeCommand& command : *commands) values.learn(command);
  return values.expand("${" + package + "_MSG_INCLUDE_DIRS}");
}

void add_package(const fs::path& share, const std::string& package, MessageFolders& all) {
  if (all.count(package) != 0) return;
  std::set<std::string> named = named_by_genmsg(share, package);
  named.insert(share / package / "msg");
  std::set<fs::path> folders;
  std::error_code none;
  for (const std::string& folder : named)
    if (fs::is_directory(folder, none)) folders.insert(folder);
  if (!folders.empty()) all.emplace(package, std::move(folders));
}

/// CMake's PKG_DIR is share/PKG/cmake.
std::set<fs::path> add_what_cmake_found(const std::string& build_dir, MessageFolders& all) {
  const CmakeCache cache = CmakeCache::nearest(build_dir);
  std::set<fs::path> shares;
  for (const CacheEntry& entry : cache.entries()) {
    const fs::path folder = entry.value, package = folder.parent_path();
    if (folder.filename() != "cmake" || entry.name != package.filename().string() + "_DIR") continue;
    add_package(package.parent_path(), package.filename(), all);
    shares.insert(package.parent_path());
  }
  return shares;
}

void add_all_below(const fs::path& share, MessageFolders& all) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(share, none))
    add_package(share, entry.path().filename(), all);
}

}  // namespace

MessageFolders message_folders(const std::map<std::string, fs::path>& workspace,
                               const std::set<std::string>& build_dirs) {
  MessageFolders all;
  std::error_code none;
  for (const auto& [name, folder] : workspace)
    all[name] =
        fs::is_directory(folder / "msg", none) ? std::set<fs::path>{folder / "msg"} : std::set<fs::path>();
  for (const std::string& build_dir : build_dirs) {
    for (const fs::path& share : add_what_cmake_found(build_dir, all)) add_all_below(share, all);
    for (const std::string& share : share_folders(build_dir)) add_all_below(share, all);
  }
  return all;
}

}  // namespace tzc::rewriter
