// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/escape/escape_context.h"
#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// What a climb finds.
class SharedElements {
 public:
  virtual ~SharedElements() = default;
  /// They can be reached through this variable, member or result.
  virtual void hold(const clang::ValueDecl* holder) = 0;
  /// An object was made to share them.
  virtual void hold_object(const clang::Expr* object) = 0;
  virtual void write(const clang::Expr* at) = 0;
};

/// Climbs from an expression through which shared elements can be reached, until it ends harmlessly, in a write or in
/// another holder. Each step gives the next expression; null: the climb ends.
class SharedClimb {
 public:
  SharedClimb(EscapeContext& context, SharedElements& elements, const FunctionView& view)
      : context_(context), elements_(elements), view_(view) {}

  void run(const clang::Expr* from) {
    at_ = from;
    while (at_) at_ = next();
  }

 private:
  using Next = const clang::Expr*;
  Next next();
  Next into_statement(const clang::Stmt* parent);
  Next into_expression(const clang::Expr* parent);
  Next into_variable(const clang::VarDecl* variable);
  Next into_capture(const clang::LambdaExpr* lambda);
  Next into_binary(const clang::BinaryOperator* op);
  Next into_operator(const clang::CXXOperatorCallExpr* call);
  Next into_assignment(const clang::CXXOperatorCallExpr* call);
  Next into_call(const clang::CallExpr* call);
  Next into_library(const clang::CallExpr* call, unsigned parameter);
  Next into_exchange(const clang::CallExpr* call);
  Next into_construction(const clang::CXXConstructExpr* made);
  Next into_list(const clang::InitListExpr* list);
  Next into_member(const clang::MemberExpr* member);
  Next into_method(const clang::CXXMemberCallExpr* call);

  Next write(const clang::Expr* at) {
    elements_.write(at);
    return nullptr;
  }
  Next done() const { return nullptr; }
  bool hold_parameter(const clang::FunctionDecl* function, unsigned parameter);
  bool hold_bound(const clang::Expr* expr);

  EscapeContext& context_;
  SharedElements& elements_;
  const FunctionView& view_;
  const clang::Expr* at_ = nullptr;
};

}  // namespace tzc::rewriter
