// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <string>

#include "facts/escape/escape_context.h"
#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// Names what one thread runs without a break: a function (by its USR), or a closure that another thread may call. A closure that is called
/// where it is made, or by a function that is known to keep nothing, is a part of its function.
class ThreadCode {
 public:
  ThreadCode(const EscapeContext& context, const FunctionView& view) : context_(context), view_(view) {}

  /// The code that a statement of the function is in.
  std::string around(const clang::Stmt* stmt) const;
  /// The closure that this code is; null: it is the function's own.
  const clang::LambdaExpr* closure_around(const clang::Stmt* stmt) const;
  /// A closure, or a function of the package by its name, goes to others here, which may give it to another thread.
  bool hands_over(const clang::Stmt* stmt) const;

 private:
  bool is_called_here(const clang::LambdaExpr* lambda) const;
  bool is_call_of(const clang::Stmt* call, const clang::Stmt* closure) const;
  bool is_only_called(const clang::VarDecl* variable, const clang::LambdaExpr* around) const;

  const EscapeContext& context_;
  const FunctionView& view_;
};

/// "/src/node.cpp:7:3", the same in every unit.
std::string place_name(const Unit& unit, const clang::Expr* expr);
/// The code that a closure is: its place in braces.
std::string closure_name(const Unit& unit, const clang::LambdaExpr* lambda);
/// Whether code is a closure, and no function.
bool is_closure(const std::string& code);
/// Whether a variable of the function around the closure is named, in a closure.
bool names_captured(const clang::Stmt* stmt);

}  // namespace tzc::rewriter
