// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"
#include "proof/cmake_cache.h"
#include "proof/scratch_folder.h"
#include "proof/scratch_workspace.h"

namespace tzc::rewriter {

/// A build tree of the user's: what it was configured from, and with which cache.
struct UserBuild {
  std::string build_dir;  ///< holds CMakeCache.txt and compile_commands.json
  std::string source;     ///< the folder that CMake configured: a workspace's src, or a package
  CmakeCache cache;

  /// None: no CMakeCache.txt there or above, or one that names no source folder.
  static std::unique_ptr<UserBuild> find(const std::string& build_dir);

  /// Whether the folder was configured for several packages at once, as catkin_make does.
  bool is_workspace() const;

  /// The folder that a copy of the sources begins with: of a package that is configured alone, the one around it, since files beside
  /// it may be included by "..".
  std::string root() const;
};

/// A scratch workspace, configured as the user's build was: the same generator and cache entries, less the
/// paths of the build, devel and install folders, which lie in the scratch folder instead.
class Configuration {
 public:
  /// `prefixes`: searched last by find_package().
  Configuration(const UserBuild& user, const std::vector<std::string>& packages,
                std::vector<std::string> prefixes);

  /// Configures with this text. The error holds CMake's first message. `contents` may differ between calls.
  Expected<void> configure(const FileContents& contents);

  /// Builds the scratch copy as a whole.
  Expected<void> build(unsigned jobs) const;

  /// Whether there was room for the copy; otherwise sources() may not be called.
  bool is_prepared() const { return sources_ != nullptr; }
  std::string build_dir() const { return *folder_ / "build"; }
  const ScratchWorkspace& sources() const { return *sources_; }

 private:
  Expected<void> prepare();
  std::vector<std::string> configured_packages() const;
  std::string source_dir() const;
  std::string initial_cache() const;
  std::string prefix_path() const;
  CacheEntry mapped(CacheEntry entry) const;
  PathMap user_trees() const;

  const UserBuild& user_;
  std::vector<std::string> packages_, prefixes_;
  std::unique_ptr<ScratchFolder> folder_;
  std::unique_ptr<ScratchWorkspace> sources_;
};

}  // namespace tzc::rewriter
