// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/compiler_error.h"

namespace tzc::rewriter {

/// The errors in what GCC or Clang printed: "file:line:column: error: text", with the notes behind and the
/// "required from" lines before them. Warnings count when they became errors. Paths are as printed.
std::vector<CompilerError> read_compiler_output(const std::string& output);

}  // namespace tzc::rewriter
