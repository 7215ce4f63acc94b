// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// What a mention of a message's array takes where the program says that it is a std::vector, which the ported array is not:
///
///   std::vector<float>& r = scan.ranges;      auto& r = scan.ranges;
///   std::vector<float>* p = &scan.ranges;     auto* p = &scan.ranges;
///   std::vector<float> v = scan.ranges;       std::vector<float> v = std::vector<float>(scan.ranges);
///   v = scan.ranges;                          scan.ranges.copy_to(v);
///
/// and what assignment_in_place() writes. A copy stays one copy; what points into `v` stays right, as with the assignment. Empty: nothing, or nothing would help (a parameter's
/// or a member's type); the compiler tells then.
std::vector<Change> changes_for_stock_vector(const Unit& unit, const clang::MemberExpr* array);

}  // namespace tzc::rewriter
