// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// `after` with line breaks in changed lines that exceed the width of `before`. Only breaks and the indentation behind
/// them are changed, in statements with such a line; the lines behind it that are aligned with a bracket move with that. The
/// width: 80, or what the longest lines but 2 % have.
std::string wrapped(const std::string& path, const std::string& before, const std::string& after);

}  // namespace tzc::rewriter
