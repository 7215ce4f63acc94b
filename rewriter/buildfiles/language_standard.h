// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "buildfiles/cmake_project.h"
#include "edits/edit.h"

namespace tzc::rewriter {

/// TZC's headers are C++14. Raises what asks for less, wherever a CMakeLists.txt says so: -std=c++11,
/// CMAKE_CXX_STANDARD 11, CXX_STANDARD 11, cxx_std_11. Later standards stay.
Edits raise_to_cxx14(const CmakeListFile& file);

}  // namespace tzc::rewriter
