// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/moved_elements.h"

#include "facts/syntax/element_names.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

using Kind = ContentEvent::Kind;

/// A library's container of messages, or of pointers to them.
bool is_container(clang::QualType type) {
  const clang::QualType plain = type.getNonReferenceType();
  return plain->isRecordType() && !is_message_or_pointer(plain) && !is_iterator(plain) &&
         (holds_messages(plain) || leads_to_messages(plain));
}

/// Whether a method leaves the elements of a container where they are.
bool only_finds(const clang::CXXMethodDecl* method) {
  static const std::set<std::string> finds = {
      "begin", "end",   "rbegin", "rend",        "front",       "back",        "at",     "data",
      "get",   "value", "find",   "lower_bound", "upper_bound", "equal_range", "reserve"};
  return method->isConst() || finds.count(method->getNameAsString()) != 0;
}

bool only_finds(const clang::CXXOperatorCallExpr* op) {
  switch (op->getOperator()) {
    case clang::OO_Subscript:
    case clang::OO_Star:
    case clang::OO_Arrow:
      return true;
    default:
      return op->isComparisonOp();
  }
}

}  // namespace

void MovedElements::index(const clang::VarDecl* variable) {
  if (is_index(view_, variable)) log_.add(Kind::moved, index_token(unit_, variable), variable->getLocation());
}

void MovedElements::entered(const clang::FunctionDecl* function) {
  for (const clang::ParmVarDecl* parameter : function->parameters()) index(parameter);
}

/// ++i, it += 2
void MovedElements::stepped(const clang::Expr* operand) {
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(operand->IgnoreParenImpCasts());
  if (const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr)
    index(variable);
  if (message_reached(operand->getType()))
    log_.add(Kind::moved, parts_.part_of(operand), operand->getExprLoc());
}

void MovedElements::container(const clang::Expr* expr) {
  if (!is_container(expr->getType()) || is_only_read(view_, expr)) return;
  const clang::Stmt* const use = use_of(view_, expr);
  if (llvm::isa_and_nonnull<clang::DeclStmt>(use)) return;  // another name
  if (const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(use)) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
    if (!method || only_finds(method)) return;
  }
  const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(use);
  if (op && only_finds(op)) return;
  log_.add(Kind::moved, parts_.part_of(expr), expr->getExprLoc());
}

void MovedElements::look_at(const clang::Stmt* stmt) {
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt)) {
    for (const clang::Decl* decl : declaration->decls())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl)) index(variable);
  } else if (const auto* step = llvm::dyn_cast<clang::UnaryOperator>(stmt)) {
    if (step->isIncrementDecrementOp()) stepped(step->getSubExpr());
  } else if (const auto* assigned = llvm::dyn_cast<clang::BinaryOperator>(stmt)) {
    if (assigned->isCompoundAssignmentOp()) stepped(assigned->getLHS());
  } else if (const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(stmt)) {
    const clang::OverloadedOperatorKind kind = call->getOperator();
    if (kind == clang::OO_PlusPlus || kind == clang::OO_MinusMinus || kind == clang::OO_PlusEqual ||
        kind == clang::OO_MinusEqual)
      stepped(call->getArg(0));
  } else if (llvm::isa<clang::MemberExpr, clang::DeclRefExpr>(stmt)) {
    const auto* expr = llvm::cast<clang::Expr>(stmt);
    container(expr);
    if (const clang::ValueDecl* lasting = lasting_index(expr); lasting && !is_read(view_, expr))
      log_.add(Kind::moved, index_token(unit_, lasting), expr->getExprLoc());
  }
}

}  // namespace tzc::rewriter
