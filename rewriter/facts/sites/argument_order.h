// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether `object.method(a, b)` may mean something else as `function(object, a, b)`. C++17 evaluates the object before the
/// arguments ([expr.call]); as an argument it has no place among the others, and GCC begins with the last one. Code of
/// libraries is taken to change nothing that the package's expressions read.
bool order_matters(const Unit& unit, const clang::CXXMemberCallExpr* call);

}  // namespace tzc::rewriter
