// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/object_starts.h"

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {

std::optional<LastingStart> lasting_start(const FlowEnd& end) {
  if (end.variable && !end.variable->hasLocalStorage())  // its statement may run again
    return LastingStart{usr_of(end.variable), false};
  if (!end.member) return {};
  const clang::QualType pointee = pointee_of(end.member->getType());
  return !pointee.isNull() && message_of(pointee) ? std::optional(LastingStart{usr_of(end.member), true})
                                                  : std::nullopt;
}

bool is_always_made(const Unit& unit, const clang::Expr* made) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *made)) {
    const auto* expr = node.get<clang::Expr>();
    const auto* op = llvm::dyn_cast_or_null<clang::BinaryOperator>(expr);
    const auto* call = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(expr);
    if (!expr) break;
    if (llvm::isa<clang::AbstractConditionalOperator>(expr) ||
        (op && (op->isLogicalOp() || op->isCommaOp())) || (call && call->getOperator() == clang::OO_Comma))
      return false;
  }
  return true;
}

bool is_in_initializer_list(const Unit& unit, const clang::Expr* made) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *made))
    if (!node.get<clang::Expr>()) return node.get<clang::CXXConstructorDecl>() != nullptr;
  return false;
}

}  // namespace tzc::rewriter
