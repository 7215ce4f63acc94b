// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// A package: its folder, canonical, and what its package.xml calls it.
struct PackagePlace {
  std::string dir, name;
};

/// The folder that was built in, canonical, of the compile_commands.json that knows the package's files. `given` is -p: a folder, or
/// the file itself, or the folder that holds those of the packages by name. Empty: the places where catkin_make, catkin build and
/// catkin_make_isolated put it, walking up from the package and then from `arguments`, the packages as the user named them (a
/// workspace may hold a package as a symbolic link); one that CMake has configured before any other.
Expected<std::string> find_build_dir(const PackagePlace& package, const std::string& given,
                                     const std::vector<std::string>& arguments);

/// The folder, of those that find_build_dir() looks at, that was configured for a package without units; empty: none.
std::string find_configured_dir(const PackagePlace& package, const std::string& given,
                                const std::vector<std::string>& arguments);

/// Whether CMake was told to write compile commands there: it writes no file when it compiles nothing. An error that says how to tell
/// it so otherwise.
Expected<void> check_exports(const std::string& configured_dir, const PackagePlace& package);

}  // namespace tzc::rewriter
