// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether a call of a function of a library runs no code of the package: known_functions.def says so, and no argument brings
/// such code. Of a function of the package: false. Lambdas that are handed over are part of the calling function's text.
bool calls_no_package_code(const Unit& unit, const clang::FunctionDecl* function,
                           llvm::ArrayRef<const clang::Expr*> arguments);

/// Whether each call of a function of a library comes back, whatever it is given.
bool comes_back(const clang::FunctionDecl* callee);

}  // namespace tzc::rewriter
