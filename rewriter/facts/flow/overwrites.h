// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <optional>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// The edit that leaves out the zero-fill of a resize, where what follows provably writes every element.
std::optional<Change> without_zero_fill(const Unit& unit, const clang::CXXMemberCallExpr* resize);
/// Where it would be made; none: nowhere.
std::optional<Place> zero_fill_place(const Unit& unit, const clang::CXXMemberCallExpr* resize);

}  // namespace tzc::rewriter
