// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <cstdint>
#include <optional>
#include <string>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// What a mention of a data array may make of the array's size.
struct ArrayGrowth {
  std::optional<std::uint64_t> most_bytes;  ///< none: any number
  bool appends = false;                     ///< to what is there already, once in the life of the message
};

/// `message.data` and the expression around it: `resize(3)` makes 3 elements, `size()` none, `assign(begin, end)`
/// any number. What is not known makes any number, and so do arrays in arrays of `message`, the type of the whole.
ArrayGrowth growth_at(const Unit& unit, const clang::MemberExpr* array, const std::string& message);

/// Whether a function of the standard library may give the message that an argument leads to another one's content, of any size, without a
/// mention of an array: std::copy(frames.begin(), frames.end(), &image), std::exchange(image, other).
bool may_fill(const clang::FunctionDecl* function, unsigned argument);

}  // namespace tzc::rewriter
