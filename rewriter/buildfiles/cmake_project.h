// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <set>
#include <string>
#include <vector>

#include "buildfiles/cmake_file.h"
#include "buildfiles/cmake_values.h"

namespace tzc::rewriter {

/// One CMakeLists.txt of a package, or a file that one includes, with what its parents may have set.
struct CmakeListFile {
  std::string path;  ///< canonical: it may be a link
  std::string content;
  std::vector<CmakeCommand> commands;
  CmakeValues values;
  std::vector<std::size_t> parents;  ///< indices into CmakeProject::files, the top level first
  std::vector<std::size_t>
      included;  ///< likewise, those whose commands run as if they stood in this one or in one below it
};

struct CmakeProject {
  std::vector<CmakeListFile>
      files;  ///< the package's own CMakeLists.txt first, then those of its add_subdirectory() and include()
};

/// Reads the package's CMakeLists.txt and, where the folders are constants, those below it.
Expected<CmakeProject> load_cmake_project(const std::string& package_dir);

/// A command and the file it stands in.
struct CmakeCommandRef {
  const CmakeListFile* file = nullptr;
  const CmakeCommand* command = nullptr;
  explicit operator bool() const { return command != nullptr; }
};

/// The command that makes a target: add_executable, add_library, or any other (catkin_add_gtest,
/// cs_add_library, ...) whose first argument may be the target's name.
CmakeCommandRef find_target(const CmakeProject& project, const std::string& target);

/// All that may make it: one branch has add_executable, and another one cuda_add_executable.
std::vector<CmakeCommandRef> makers_of_target(const CmakeProject& project, const std::string& target);

/// The commands of that name whose first argument may be the target's name, those in the body of the package's own macro or
/// function that is called with it included.
std::vector<CmakeCommandRef> commands_of_target(const CmakeProject& project, const std::string& command,
                                                const std::string& target);

/// Whether a command runs wherever `maker` makes the target: it stands in no branch of an if(), and in no loop, that the latter does not stand in,
/// but for one that asks for the target.
bool runs_with_target(const CmakeCommandRef& command, const CmakeCommandRef& maker,
                      const std::string& target);

/// Whether a command runs whatever its file decides.
bool always_runs(const CmakeCommandRef& command);

/// Whether catkin_simple() has given the target, by whatever command it is made, the folders of all packages that package.xml builds with:
/// it calls include_directories(${catkin_INCLUDE_DIRS}), which reaches the folder that it is called in and those added behind it. False
/// wherever that is not certain.
bool is_behind_catkin_simple(const CmakeProject& project, const std::string& target);

/// The files whose settings reach a target, as indices: those in which a command's first argument may be its name, those above
/// them, and what these include.
std::set<std::size_t> files_of_target(const CmakeProject& project, const std::string& target);

}  // namespace tzc::rewriter
