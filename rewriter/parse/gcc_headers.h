// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

namespace tzc::rewriter {

/// Folder of the files below, in memory only.
constexpr const char* gcc_header_dir = "/tzc-rewrite/gcc";
/// Included first by every unit.
constexpr const char* gcc_prelude = "/tzc-rewrite/gcc/prelude.h";

/// Headers of GCC that packages use and Clang does not have: path -> content.
const std::map<std::string, std::string>& gcc_headers();

}  // namespace tzc::rewriter
