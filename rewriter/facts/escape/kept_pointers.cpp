// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/kept_pointers.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/StmtCXX.h>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/lock_names.h"

namespace tzc::rewriter {
namespace {

using Kind = ElementUse::Kind;

bool is_step(clang::OverloadedOperatorKind op) {
  return op == clang::OO_PlusPlus || op == clang::OO_MinusMinus || op == clang::OO_Plus ||
         op == clang::OO_Minus || op == clang::OO_PlusEqual || op == clang::OO_MinusEqual;
}

/// Its value may still lead to the elements: x + 1, x++, (float*)x, x += 4; ++x, ++y.
bool leads_on(const clang::Stmt* around) {
  if (llvm::isa<clang::ParenExpr, clang::CastExpr, clang::ExprWithCleanups, clang::MaterializeTemporaryExpr>(
          around))
    return true;
  if (const auto* step = llvm::dyn_cast<clang::UnaryOperator>(around)) return step->isIncrementDecrementOp();
  if (const auto* sum = llvm::dyn_cast<clang::BinaryOperator>(around))
    return sum->isCommaOp() ||
           ((sum->isAdditiveOp() || sum->isCompoundAssignmentOp()) && sum->getType()->isPointerType());
  const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(around);
  return call && is_step(call->getOperator());
}

/// *x, x[i], x->y
bool follows(const clang::Stmt* around, const clang::Stmt* pointer) {
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(around))
    return op->getOpcode() == clang::UO_Deref;
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(around))
    return element->getBase() == pointer;
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(around)) return member->isArrow();
  const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(around);
  if (!call || call->getArg(0) != pointer) return false;
  return call->getOperator() == clang::OO_Star || call->getOperator() == clang::OO_Subscript ||
         call->getOperator() == clang::OO_Arrow;
}

}  // namespace

bool writes_to(const std::string& function, unsigned argument) {
  static const std::set<std::string> to_first = {
      "memset",           "memcpy",       "memmove",     "std::memset",    "std::memcpy",   "std::memmove",
      "std::fill",        "std::fill_n",  "std::iota",   "std::sort",      "std::generate", "std::generate_n",
      "std::stable_sort", "std::reverse", "std::rotate", "std::shuffle",   "std::replace",  "std::replace_if",
      "std::partition",   "std::unique",  "std::remove", "std::remove_if", "std::swap"};
  static const std::set<std::string> to_third = {"std::copy",         "std::copy_n",        "std::copy_if",
                                                 "std::move",         "std::copy_backward", "std::transform",
                                                 "std::replace_copy", "std::reverse_copy"};
  return (argument == 0 && to_first.count(function) != 0) || (argument >= 2 && to_third.count(function) != 0);
}

/// The variable of this function that the pointer is the first value of.
const clang::VarDecl* KeptPointers::variable_of(const clang::Expr* pointer) const {
  const clang::Stmt* value = pointer;
  const clang::Stmt* around = view_.parent(value);
  while (around && leads_on(around)) value = around, around = view_.parent(around);
  const auto* declaration = llvm::dyn_cast_or_null<clang::DeclStmt>(around);
  if (!declaration) return nullptr;
  for (const clang::Decl* decl : declaration->decls()) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
    if (variable && variable->getInit() == value && variable->hasLocalStorage() &&
        !variable->getType()->isReferenceType())
      return variable;
  }
  return nullptr;
}

KeptPointers::Value KeptPointers::value_of(const clang::DeclRefExpr* use) const {
  Value value{use, view_.parent(use)};
  while (value.around && !follows(value.around, value.pointer) && leads_on(value.around))
    value = {value.around, view_.parent(value.around)};
  return value;
}

/// What stands for the element, or a part of it, where the variable is followed; null: it is not.
const clang::Stmt* KeptPointers::element_of(const clang::DeclRefExpr* use) const {
  const Value value = value_of(use);
  if (!value.around || !follows(value.around, value.pointer)) return nullptr;
  const clang::Stmt* element = value.around;
  for (const clang::Stmt* around = view_.parent(element); around; around = view_.parent(around)) {
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(around);
    const bool is_part = member && !member->isArrow() && llvm::isa<clang::FieldDecl>(member->getMemberDecl());
    if (!is_part && !llvm::isa<clang::ParenExpr, clang::ArraySubscriptExpr>(around)) break;
    element = around;
  }
  return element;
}

bool KeptPointers::is_written(const clang::DeclRefExpr* use) const {
  if (const clang::Stmt* element = element_of(use)) return is_assigned(view_.parent(element), element);
  const Value value = value_of(use);
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(value.around);
  const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
  if (!function) return false;
  for (unsigned i = 0; i < call->getNumArgs(); ++i)
    if (call->getArg(i) == value.pointer && writes_to(qualified_name_of(function), i)) return true;
  return false;
}

/// x += 4; x = x + 4; if (x != x.end()): no element is read, and nothing else gets the pointer.
bool KeptPointers::only_steps(const clang::DeclRefExpr* use) const {
  const clang::Stmt* around = value_of(use).around;
  if (const auto* op = llvm::dyn_cast_or_null<clang::BinaryOperator>(around)) {
    const auto* target = llvm::dyn_cast<clang::DeclRefExpr>(op->getLHS()->IgnoreParens());
    return op->isComparisonOp() || (op->isAssignmentOp() && target && target->getDecl() == use->getDecl());
  }
  if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(around))
    return member->getMemberDecl()->getNameAsString() == "end";  // of an iterator
  const auto* call = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(around);
  return (call && call->isComparisonOp()) ||
         llvm::isa_and_nonnull<clang::CompoundStmt, clang::ForStmt, clang::WhileStmt, clang::IfStmt>(around);
}

bool KeptPointers::stands_alone(const clang::VarDecl* variable) const {
  const clang::DeclStmt* declaration = view_.declaration(variable);
  const clang::Stmt* scope = declaration ? view_.parent(declaration) : nullptr;
  if (!scope || view_.jumps()) return false;
  for (const clang::DeclRefExpr* use : view_.uses(variable))
    if (view_.lambda_around(use) != view_.lambda_around(declaration)) return false;
  const FunctionView::Span life{view_.span(declaration).enter, view_.span(scope).exit};
  for (const SeenEvent& seen : events_)
    if (life.contains(seen.span)) return false;
  return llvm::none_of(view_.statements(), [&](const clang::Stmt* stmt) {
    return life.contains(view_.span(stmt)) && (may_synchronize(stmt) || code_.hands_over(stmt));
  });
}

KeptPointers::Kinds KeptPointers::kinds_of(const clang::Expr* pointer) const {
  const clang::VarDecl* variable = variable_of(pointer);
  if (!variable) return {Kind::walk};
  const std::vector<const clang::DeclRefExpr*>& uses = view_.uses(variable);
  if (llvm::none_of(uses, [&](const clang::DeclRefExpr* use) { return is_written(use); }))
    return {Kind::walk};
  // One that may be read through, in a run that does not write, may meet a thread that publishes.
  const bool only_writes = llvm::all_of(uses, [&](const clang::DeclRefExpr* use) {
    return is_written(use) || (!element_of(use) && only_steps(use));
  });
  return only_writes && stands_alone(variable) ? Kinds{Kind::write} : Kinds{Kind::write, Kind::walk};
}

}  // namespace tzc::rewriter
