// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <vector>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// The functions that an argument of a subscribing call leads to: those that it names or binds, lambdas, function objects
/// of the package, and what the variables in it begin with.
std::vector<const clang::FunctionDecl*> callback_functions(const Unit& unit, const clang::Stmt* argument);
/// Whether it leads to others besides: through a parameter, a member, or a variable that is set later.
bool calls_unknown_functions(const Unit& unit, const clang::Stmt* argument);

}  // namespace tzc::rewriter
