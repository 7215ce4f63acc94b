// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/folder_set.h"

//  apart                             in source
//    demo/src/node.cpp                 demo/src/node.cpp
//    demo/CMakeLists.txt               demo/CMakeLists.txt
//    demo/build/CMakeCache.txt         demo/CMakeCache.txt
//    demo/build/CMakeFiles             demo/CMakeFiles

namespace tzc::rewriter {

/// Whether the build folder is the package's or lies above it, so that sources and results share folders.
bool builds_in_source(const std::string& build_dir, const std::string& package_dir);

/// The folders whose files are no sources of the package: the build folder, and what CMake and catkin make in the package.
FolderSet generated_folders(const std::string& build_dir, const std::string& package_dir);

/// What a copy of the packages does without: the build folder, or what an in-source build has of its own in them. As the
/// caller names them.
std::vector<std::string> build_paths(const std::string& build_dir,
                                     const std::vector<std::string>& package_dirs);

}  // namespace tzc::rewriter
