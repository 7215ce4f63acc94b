// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <optional>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// std::bind(function, a), std::thread(function, a) and their like: a function of the package that is called later,
/// with copies of the arguments.
struct BoundCall {
  const clang::FunctionDecl* function;
  const clang::DeclRefExpr* name;  ///< of the function
  llvm::ArrayRef<const clang::Expr*> arguments;
  unsigned first;  ///< which argument becomes the first parameter

  /// What a parameter is given; null: nothing is bound to it.
  const clang::Expr* given(unsigned parameter) const {
    return first + parameter < arguments.size() ? arguments[first + parameter] : nullptr;
  }
};

/// Of a call or construction; none: it binds no function of the package.
std::optional<BoundCall> bound_call(const Unit& unit, const clang::Expr* expr);

}  // namespace tzc::rewriter
