// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/bound_elements.h"

#include <clang/AST/ExprCXX.h>

#include <algorithm>
#include <cstdint>
#include <string>

#include "facts/syntax/message_parts.h"

namespace tzc::rewriter {
namespace {

constexpr std::uint64_t most_bound = 64;  // as of tzc::MessageArray

bool is_small_number(const clang::Expr* expr, const clang::ASTContext& ast) {
  clang::Expr::EvalResult value;
  return !expr->isValueDependent() && expr->EvaluateAsInt(value, ast) && !value.Val.getInt().isNegative() &&
         value.Val.getInt().getLimitedValue() <= most_bound;
}

/// A message's own array, also by a name whose type is deduced: `auto& channels = cloud.channels`. Null: it may be a std::vector in the port.
const clang::MemberExpr* own_array(const clang::Expr* array) {
  array = array->IgnoreParenImpCasts();
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(array);
  const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  if (variable && variable->getType()->isReferenceType() && variable->getType()->getContainedAutoType() &&
      variable->getInit())
    array = variable->getInit()->IgnoreParenImpCasts();
  return llvm::dyn_cast<clang::MemberExpr>(array);
}

/// The variable that has the array, not through what leads elsewhere. Null: there is none.
const clang::VarDecl* owner_of(const clang::MemberExpr* array) {
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(array->getBase()->IgnoreParenImpCasts());
  const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  return variable && variable->hasLocalStorage() && !variable->getType()->isReferenceType() &&
                 is_stock_or_twin(variable->getType())
             ? variable
             : nullptr;
}

/// Not where each run of a loop has a message of its own.
bool grows_with_a_loop(const FunctionView& view, const clang::Expr* mention, const clang::MemberExpr* array) {
  const clang::VarDecl* const owner = owner_of(array);
  const clang::DeclStmt* const declaration = owner ? view.declaration(owner) : nullptr;
  return std::any_of(view.repeated().begin(), view.repeated().end(), [&](const FunctionView::Span& loop) {
    return loop.contains(view.span(mention)) && !(declaration && loop.contains(view.span(declaration)));
  });
}

}  // namespace

bool adds_bound_elements(const FunctionView& view, const clang::Expr* array) {
  const clang::MemberExpr* const own = own_array(array);
  const auto* member = own ? llvm::dyn_cast_or_null<clang::MemberExpr>(use_of(view, array)) : nullptr;
  const auto* call = member ? llvm::dyn_cast_or_null<clang::CXXMemberCallExpr>(view.parent(member)) : nullptr;
  if (!call || !call->getMethodDecl()) return false;
  const std::string name = call->getMethodDecl()->getNameAsString();
  if (name == "resize")
    return call->getNumArgs() == 1 && is_small_number(call->getArg(0), view.function()->getASTContext());
  if (view.jumps() || view.lambda_around(array) || grows_with_a_loop(view, array, own)) return false;
  if (name == "emplace_back") return call->getNumArgs() == 0;
  return name == "push_back" && call->getMethodDecl()->getParamDecl(0)->getType()->isLValueReferenceType();
}

}  // namespace tzc::rewriter
