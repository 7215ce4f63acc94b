// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// `after` with its changed lines formatted by the .clang-format that applies to `path`. Where there is none that Clang can
/// read, continuation lines keep their alignment and changed lines the width of the file.
/// Changes white space only: ignores options that would do more.
std::string format_changes(const std::string& path, const std::string& before, const std::string& after);

}  // namespace tzc::rewriter
