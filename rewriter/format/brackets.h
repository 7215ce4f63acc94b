// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace tzc::rewriter {

/// The brackets of a line that stay open at its end, and how many of earlier lines it closes.
struct Brackets {
  std::vector<std::size_t> open;  ///< columns, from the outermost
  std::size_t closed = 0;
};

/// The line up to its `//`, if it has one outside of literals.
std::string_view without_comment(std::string_view line);

/// Brackets in literals and comments are none.
Brackets brackets_of(std::string_view line);

}  // namespace tzc::rewriter
