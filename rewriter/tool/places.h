// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// A folder of the user's after the XDG base directory specification: the variable's value when it is an absolute
/// path, else this folder in $HOME; empty: neither is set.
std::string user_folder(const char* variable, const char* in_home);

/// The packages of a command-line argument: the folder itself, or all below it that have a package.xml
/// (without CATKIN_IGNORE and hidden folders). Canonical, sorted.
Expected<std::vector<std::string>> find_packages_at(const std::string& argument);

/// The folder that holds the packages of the package's workspace: the highest one above it beside which catkin's tools have left
/// their marks, else the next one that is called src, else the package's parent.
std::string source_space(const std::string& package_dir);
/// Whether such a folder belongs to a workspace, and is not just the one that holds a package.
bool is_workspace(const std::string& source_space);

/// A package: its folder, canonical, and what its package.xml calls it.
struct PackagePlace {
  std::string dir, name;
};

/// The folder of the compile_commands.json that knows the package's files. `given` is -p (a folder or the
/// file itself); empty: the places where catkin_make, catkin build and catkin_make_isolated put it, walking
/// up from the package and then from `arguments`, the packages as the user named them (a workspace may hold a
/// package as a symbolic link).
Expected<std::string> find_build_dir(const PackagePlace& package, const std::string& given,
                                     const std::vector<std::string>& arguments);

/// The folder, of those that find_build_dir() looks at, that was configured for a package without units; empty: none.
std::string find_configured_dir(const PackagePlace& package, const std::string& given,
                                const std::vector<std::string>& arguments);

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
