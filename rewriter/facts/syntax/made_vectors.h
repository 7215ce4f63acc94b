// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// What an array of a message is assigned from a std::vector that is made on the spot, where it lies:
///
///   scan.ranges = std::vector<float>(n);                          scan.ranges.assign(n, 0);
///   scan.ranges = std::vector<float>(n, 1);                       scan.ranges.assign(n, 1);
///   cloud.indices = std::vector<int>(all.begin(), all.end());     cloud.indices.assign(all.begin(), all.end());
///
/// Empty: the assignment is another one, or it is not shown that both do the same. The vector is complete before the array changes;
/// so iterators must be those of an object that has elements of its own, and nothing in the arguments may run code that changes
/// which array is meant.
std::vector<Change> assignment_in_place(const Unit& unit, const clang::CXXOperatorCallExpr* assignment);

}  // namespace tzc::rewriter
