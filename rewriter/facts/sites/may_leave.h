// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether the path of a function may end in the middle: by an exception, by the end of the program.

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Whether an expression itself, without those in it and without what it calls, may throw or give the thread away: throw, a cast or
/// typeid that throws, an array that is made with a size that may be none, a suspension, an assembler statement.
bool may_leave(const Unit& unit, const clang::Stmt* stmt);

/// Whether a call of a library's function comes back, but for want of memory: nothing of the package runs in it, and known_functions.def
/// knows the function, or what it is given shows it. A size is harmless when its type or its parts bound it, a position when it is 0.
bool surely_returns(const Unit& unit, const clang::FunctionDecl* callee,
                    llvm::ArrayRef<const clang::Expr*> arguments);

}  // namespace tzc::rewriter
