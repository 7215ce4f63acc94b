// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// Functions and closures that are handed over, and who gets them: what runs them on one thread at a time (a subscription, a timer), a thread
/// (ONE_AT_A_TIME and THREAD in known_functions.def), or something else.
class ThreadStarts {
 public:
  explicit ThreadStarts(const Unit& unit) : unit_(unit) {}

  /// `mention` names the function, and does not call it: it may be called at any time.
  void note(const clang::FunctionDecl* function, const clang::DeclRefExpr* mention);
  /// What is done with the closure is seen where it is made.
  void note(const clang::LambdaExpr* lambda);
  /// All that was noted.
  Facts take() { return std::move(found_); }

 private:
  void add(const std::string& code, const clang::Expr* mention);

  const Unit& unit_;
  Facts found_;
};

}  // namespace tzc::rewriter
