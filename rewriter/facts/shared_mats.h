// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <memory>
#include <set>
#include <vector>

#include "facts/escape_context.h"
#include "facts/function_view.h"

namespace tzc::rewriter {

/// Follows the image that cv_bridge::toCvShare gives, and everything that shares its elements, to what may write to
/// them. Nothing but the level of subscriptions depends on it: at run time a write changes private pages.
class SharedMats {
 public:
  explicit SharedMats(EscapeContext& context) : context_(context) {}

  /// A function with a body, not a lambda.
  void analyse(const clang::FunctionDecl* definition);
  /// The members that a shared image was put into, in all functions that were analysed.
  void finish();

 private:
  using Messages = std::vector<EntityId>;
  const FunctionView& view_of(const clang::FunctionDecl* definition);
  void note(const clang::Expr* write, const Messages& messages);
  const clang::Expr* write_through(const FunctionView& view, const clang::Expr* at);
  const clang::Expr* write_in_uses(const FunctionView& view, const clang::ValueDecl* variable);
  const clang::Expr* write_in(const clang::FunctionDecl* function, unsigned parameter, const clang::Expr* at);
  const clang::Expr* write_in_target(const FunctionView& view, const clang::Expr* target);
  const clang::Expr* write_in_construction(const clang::CXXConstructExpr* made, const clang::Expr* at);

  /// One step upwards: what writes, or where to go on; neither: it ends harmlessly.
  struct Step {
    const clang::Expr* write = nullptr;
    const clang::Expr* next = nullptr;
  };
  Step into(const FunctionView& view, const clang::Expr* at, const clang::Expr* parent);
  Step into_binary(const FunctionView& view, const clang::Expr* at, const clang::BinaryOperator* op);
  Step into_operator(const FunctionView& view, const clang::Expr* at, const clang::CXXOperatorCallExpr* call);
  Step into_call(const clang::Expr* at, const clang::CallExpr* call);
  Step into_method(const FunctionView& view, const clang::MemberExpr* member);

  EscapeContext& context_;
  std::map<const clang::FunctionDecl*, std::unique_ptr<FunctionView>> views_;
  std::set<const clang::ValueDecl*> seen_;
  std::map<const clang::ValueDecl*, Messages> kept_;
  Messages current_;
  std::vector<const clang::FunctionDecl*> functions_;
};

}  // namespace tzc::rewriter
