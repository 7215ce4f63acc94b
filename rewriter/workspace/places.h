// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// A folder of the user's after the XDG base directory specification: the variable's value when it is an absolute
/// path, else this folder in $HOME; empty: neither is set.
std::string user_folder(const char* variable, const char* in_home);

/// The folder that holds the packages of the package's workspace: the highest one above it beside which catkin's tools have left
/// their marks, else the next one that is called src, else the package's parent.
std::string source_space(const std::string& package_dir);
/// Whether such a folder belongs to a workspace, and is not just the one that holds a package.
bool is_workspace(const std::string& source_space);

/// Folders that hold installed ROS packages: of the catkin that the build folder was configured with, of the
/// environment's ROS_PACKAGE_PATH and CMAKE_PREFIX_PATH, /usr/share last.
std::vector<std::string> share_folders(const std::string& build_dir);

/// Prefixes of the install or build tree that this program, or a folder of `given` (--tzc-include), belongs to:
/// where CMake finds TZC.
std::vector<std::string> find_tzc_prefixes(const std::vector<std::string>& given);

/// The folder of this program.
std::string own_folder();

/// TZC's include folders, the one with tzc/ros.h first: `given`, else those of the install or build tree that
/// this program belongs to.
Expected<std::vector<std::string>> find_tzc_includes(const std::vector<std::string>& given);

}  // namespace tzc::rewriter
