// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/message_folders.h"

#include <utility>

#include "proof/cmake_cache.h"
#include "workspace/genmsg_files.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// genmsg's words and share/PKG/msg, as far as they are there.
std::set<fs::path> folders_at(const fs::path& share, const std::string& package) {
  std::set<std::string> named = genmsg_folders(share, package);
  named.insert(share / package / "msg");
  std::set<fs::path> folders;
  std::error_code none;
  for (const std::string& folder : named)
    if (fs::is_directory(folder, none)) folders.insert(folder);
  return folders;
}

void add_package(const fs::path& share, const std::string& package, MessageFolders& all) {
  if (all.count(package) != 0) return;
  std::set<fs::path> folders = folders_at(share, package);
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

MessageFolders message_folders(const std::map<std::string, std::string>& workspace,
                               const std::set<std::string>& build_dirs) {
  MessageFolders all;
  std::error_code none;
  const std::set<fs::path> shares = devel_shares(build_dirs);
  for (const auto& [name, folder] : workspace) {
    std::set<fs::path>& folders = all[name];
    const fs::path own = fs::path(folder) / "msg";
    if (fs::is_directory(own, none)) folders.insert(own);
    for (const fs::path& share : shares) folders.merge(folders_at(share, name));
  }
  for (const std::string& build_dir : build_dirs) {
    for (const fs::path& share : add_what_cmake_found(build_dir, all)) add_all_below(share, all);
    for (const std::string& share : share_folders(build_dir)) add_all_below(share, all);
  }
  return all;
}

std::set<fs::path> devel_shares(const std::set<std::string>& build_dirs) {
  std::set<fs::path> shares;
  for (const std::string& build_dir : build_dirs) {
    const std::string prefix = CmakeCache::nearest(build_dir).value("CATKIN_DEVEL_PREFIX");
    if (!prefix.empty()) shares.insert(fs::path(prefix) / "share");
  }
  return shares;
}

}  // namespace tzc::rewriter
