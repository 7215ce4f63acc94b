// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "buildfiles/cmake_project.h"
#include "model/edit.h"

namespace tzc::rewriter {

/// TZC's headers are C++14. Raises earlier standards in a CMakeLists.txt to it: -std=c++11,
/// CMAKE_CXX_STANDARD 11, CXX_STANDARD 11, cxx_std_11, and the value of a variable in such a place that the file sets once. Later
/// standards stay.
Edits raise_to_cxx14(const CmakeListFile& file);

}  // namespace tzc::rewriter
