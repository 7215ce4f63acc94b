// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// `after` with its changed lines formatted by the .clang-format that is in force for `path`; as it is where
/// there is none, or one that Clang 19 can not read. Changes white space only: options that would do more are
/// not followed.
std::string format_changes(const std::string& path, const std::string& before, const std::string& after);

}  // namespace tzc::rewriter
