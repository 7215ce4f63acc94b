// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/containing_object.h"

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/calls.h"

namespace tzc::rewriter {
namespace {

/// frame->image, (*frame).image, frames[i].image, frame.get()->image: what the step starts from.
const clang::Expr* step_back(const clang::Expr* expr) {
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return member->getBase();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr)) return op->getArg(0);
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getSubExpr();
  if (const auto* subscript = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return subscript->getBase();
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr);
  return call ? call->getImplicitObjectArgument() : nullptr;
}

/// The variable or own member at which an expression begins; null: neither.
const clang::ValueDecl* begin_of(const clang::Expr* expr) {
  for (; expr; expr = step_back(expr)) {
    expr = expr->IgnoreParenImpCasts();
    if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return reference->getDecl();
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
    if (member && llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts()))
      return member->getMemberDecl();
  }
  return nullptr;
}

/// What a member message is part of; null: of this object, or a global.
const clang::ValueDecl* object_of(const clang::Expr* message) {
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(message->IgnoreParenImpCasts());
  const clang::Expr* base = member ? member->getBase()->IgnoreParenImpCasts() : nullptr;
  return base && !llvm::isa<clang::CXXThisExpr>(base) ? begin_of(base) : nullptr;
}

/// frames[i], frames.at(i), frames.front(): the container; null: no element is named.
const clang::Expr* container_of(const clang::Expr* expr) {
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return element->getBase();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr))
    return op->getOperator() == clang::OO_Subscript ? op->getArg(0) : nullptr;
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr);
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  if (!method || !method->getIdentifier()) return nullptr;
  const llvm::StringRef name = method->getName();
  return name == "at" || name == "front" || name == "back" ? call->getImplicitObjectArgument() : nullptr;
}

bool is_made(const clang::Expr* value) {
  if (!value) return true;
  value = value->IgnoreUnlessSpelledInSource();
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(value)) {
    if (made->getNumArgs() == 0 || llvm::isa<clang::CXXDefaultArgExpr>(made->getArg(0))) return true;
    return made->getNumArgs() == 1 && is_made(made->getArg(0));
  }
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(value))
    return llvm::all_of(list->inits(), is_made);
  if (llvm::isa<clang::CXXNewExpr, clang::CXXScalarValueInitExpr, clang::ImplicitValueInitExpr,
                clang::CXXDefaultInitExpr>(value))
    return true;
  const auto* call = llvm::dyn_cast<clang::CallExpr>(value);
  return call && call->getDirectCallee() && makes_object(call);
}

/// A pointer or reference to what outlives the function, or an element of it in a loop over a range.
bool leads_to_what_lasts(const clang::VarDecl* variable) {
  const clang::QualType type = variable->getType();
  const bool leads = type->isReferenceType() || type->isPointerType() || variable->isImplicit();
  if (!leads || !variable->getInit()) return false;
  const clang::ValueDecl* begin = begin_of(variable->getInit());
  const auto* other = llvm::dyn_cast_or_null<clang::VarDecl>(begin);
  const bool is_of_loop = other && other->isImplicit();  // the range, or the iterator of a loop
  return begin && (!other || !other->hasLocalStorage() || (is_of_loop && leads_to_what_lasts(other)));
}

}  // namespace

const clang::VarDecl* object_that_ends(const clang::Expr* message) {
  const auto* variable = llvm::dyn_cast_or_null<clang::VarDecl>(object_of(message));
  return variable && variable->hasLocalStorage() && !leads_to_what_lasts(variable) ? variable : nullptr;
}

const clang::VarDecl* object_of_element_that_ends(const clang::Expr* message) {
  const clang::Expr* whole = message->IgnoreParenImpCasts();
  while (const clang::Expr* container = container_of(whole)) whole = container->IgnoreParenImpCasts();
  return whole != message->IgnoreParenImpCasts() ? object_that_ends(whole) : nullptr;
}

bool is_made_empty(const clang::VarDecl* object) {
  return !llvm::isa<clang::ParmVarDecl>(object) && !object->isCXXForRangeDecl() && is_made(object->getInit());
}

}  // namespace tzc::rewriter
