// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/empty_copies.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/Stmt.h>

#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

/// Its other fields, however deep, have no data arrays.
bool has_one_array(clang::QualType message) {
  const clang::CXXRecordDecl* record = message.getNonReferenceType()->getAsCXXRecordDecl();
  if (!record) return false;
  unsigned arrays = 0;
  bool others = false;
  for (const clang::FieldDecl* field : record->fields()) {
    arrays += is_stock_or_twin_array(field->getType());
    others = others || message_reached(field->getType());
  }
  return arrays == 1 && !others;
}

bool is_zero(const clang::Expr* expr) {
  const auto* literal = llvm::dyn_cast<clang::IntegerLiteral>(expr->IgnoreParenImpCasts());
  return literal && literal->getValue() == 0;
}

/// The message of the array that has the function called: in.data.empty(), in.data.size(). Null: it is another expression.
const clang::Expr* message_asked(const clang::Expr* expr, llvm::StringRef question) {
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr->IgnoreParenImpCasts());
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  if (!method || !method->getIdentifier() || method->getName() != question) return nullptr;
  const auto* array =
      llvm::dyn_cast<clang::MemberExpr>(call->getImplicitObjectArgument()->IgnoreParenImpCasts());
  return array && is_stock_or_twin_array(array->getType()) ? array->getBase() : nullptr;
}

/// The message whose array has no elements where the condition holds; null: it says none.
const clang::Expr* message_that_is_empty(const clang::Expr* condition) {
  condition = condition->IgnoreParenImpCasts();
  if (const clang::Expr* message = message_asked(condition, "empty")) return message;
  const auto* op = llvm::dyn_cast<clang::BinaryOperator>(condition);
  if (!op || op->getOpcode() != clang::BO_EQ) return nullptr;
  return is_zero(op->getRHS())   ? message_asked(op->getLHS(), "size")
         : is_zero(op->getLHS()) ? message_asked(op->getRHS(), "size")
                                 : nullptr;
}

/// The statement, or its first one where it is a block: nothing runs before it.
const clang::Stmt* first_of(const clang::Stmt* stmt) {
  const auto* block = llvm::dyn_cast<clang::CompoundStmt>(stmt);
  return !block ? stmt : block->body_empty() ? nullptr : block->body_front();
}

/// The `if` whose branch runs the expression first. Null: there is none.
const clang::IfStmt* branch_that_starts_with(const FunctionView& view, const clang::Expr* expr) {
  const clang::Stmt* inner = expr;
  for (const clang::Stmt* around = view.parent(expr); around; inner = around, around = view.parent(around)) {
    if (llvm::isa<clang::LambdaExpr>(around)) return nullptr;
    const auto* branch = llvm::dyn_cast<clang::IfStmt>(around);
    if (!branch) continue;
    const clang::Stmt* const then = branch->getThen();
    return inner == then && view.span(first_of(then)).contains(view.span(expr)) ? branch : nullptr;
  }
  return nullptr;
}

}  // namespace

bool copies_nothing(const FunctionView& view, const MessageParts& parts, const clang::Expr* copy) {
  const clang::Expr* const original = copied_message(copy);
  if (!original || !original->getType().isConstQualified() || !has_one_array(original->getType()))
    return false;
  const clang::IfStmt* const branch = branch_that_starts_with(view, copy);
  const clang::Expr* const empty = branch ? message_that_is_empty(branch->getCond()) : nullptr;
  const MessagePart part = parts.part_of(original);
  return empty && !part.empty() && parts.part_of(empty) == part;
}

}  // namespace tzc::rewriter
