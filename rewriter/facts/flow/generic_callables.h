// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether a call or construction of code outside the package may give what it gets to code of the package that takes anything: a
/// generic closure, a function object whose call operator is a template, a class with a constructor template. Neither a type
/// nor a flow that stands in the source shows that it gets a message.
bool may_call_generic_code(const Unit& unit, const clang::CallExpr* call);
bool may_call_generic_code(const Unit& unit, const clang::CXXConstructExpr* construct);

}  // namespace tzc::rewriter
