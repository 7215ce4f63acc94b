// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// `after` with its changed lines formatted by the .clang-format that applies to `path`: no other line changes but continuation lines that
/// keep their alignment with a bracket, and no statement moves. Where there is none that Clang can read, changed lines keep the width of
/// the file instead.
/// Changes white space only: ignores options that would do more.
std::string format_changes(const std::string& path, const std::string& before, const std::string& after);

}  // namespace tzc::rewriter
