// SPDX-License-Identifier: BSD-3-Clause
// Loops that write every element of an array that was just resized:
//   for (int i = 0; i < n; ++i) scan.ranges[i] = values[i];
//   for (float& range : scan.ranges) range = 0.1f;
// A loop may write the sister arrays of the same message, too.
// What is written is a number that is no element of the array (number_values.h).
#include "facts/element_loops.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/StmtCXX.h>

#include "facts/calls.h"
#include "facts/message_type.h"
#include "facts/number_values.h"

namespace tzc::rewriter {
namespace {

std::string text_of(const Unit& unit, const clang::Expr* expr) {
  return unit.squeezed(expr->IgnoreParenImpCasts());
}

/// Of a number that the compiler knows, its value: a macro of the same name may have another one by now.
std::string size_of(const Unit& unit, const clang::Expr* expr) {
  return constant_integer(unit, expr).value_or(text_of(unit, expr));
}

/// Whether the name occurs as a word: the loop's variable would hide it.
bool mentions(const std::string& text, llvm::StringRef name) {
  const auto is_part = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) || text[at] == '_');
  };
  for (std::size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1))
    if (!is_part(at + name.size()) && (at == 0 || !is_part(at - 1))) return true;
  return false;
}

/// Names and literals, and sizes of other arrays; where nothing has run since it was evaluated, whatever is a number.
bool has_kept_its_value(const Unit& unit, const ResizedArray& array) {
  const clang::Expr* size = array.size->IgnoreParenImpCasts();
  if (!size->getType()->isIntegerType() || !NumberValues(unit, Calls::sizes).is_number(size)) return false;
  if (array.is_fresh || constant_integer(unit, size)) return true;
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(size);
  return reference && reference->getType().isConstQualified();
}

/// A statement that assigns a number; null: another one.
const clang::BinaryOperator* assignment_of(const Unit& unit, const clang::Stmt* statement) {
  if (const auto* full = llvm::dyn_cast_or_null<clang::ExprWithCleanups>(statement))
    statement = full->getSubExpr();
  const auto* op = llvm::dyn_cast_or_null<clang::BinaryOperator>(statement);
  const bool assigns = op && op->getOpcode() == clang::BO_Assign && is_plain_number(op->getLHS()->getType());
  return assigns && NumberValues(unit, Calls::known).is_number(op->getRHS()) ? op : nullptr;
}

std::vector<const clang::Stmt*> statements_of(const clang::Stmt* body) {
  const auto* block = llvm::dyn_cast_or_null<clang::CompoundStmt>(body);
  if (!block) return {body};
  return {block->body_begin(), block->body_end()};
}

/// Another array of the same message.
bool is_sister(const Unit& unit, const clang::Expr* expr, const clang::Expr* array) {
  const auto* one = llvm::dyn_cast<clang::MemberExpr>(expr->IgnoreParenImpCasts());
  const auto* other = llvm::dyn_cast<clang::MemberExpr>(array->IgnoreParenImpCasts());
  const std::string base = one ? text_of(unit, one->getBase()) : std::string();
  return one && other && !base.empty() && is_data_array(one->getType()) && is_data_array(other->getType()) &&
         one->getMemberDecl() != other->getMemberDecl() && base == text_of(unit, other->getBase());
}

bool is_zero(const clang::Expr* expr) {
  const auto* literal = expr ? llvm::dyn_cast<clang::IntegerLiteral>(expr->IgnoreParenImpCasts()) : nullptr;
  return literal && literal->getValue() == 0;
}

bool is_use_of(const clang::Expr* expr, const clang::VarDecl* variable) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
  return reference && reference->getDecl() == variable;
}

/// for (int i = 0; ...; ++i); null: another form
const clang::VarDecl* counter_of(const clang::ForStmt* loop) {
  const auto* declaration = llvm::dyn_cast_or_null<clang::DeclStmt>(loop->getInit());
  const auto* step = llvm::dyn_cast_or_null<clang::UnaryOperator>(loop->getInc());
  if (!declaration || !declaration->isSingleDecl() || !step || !step->isIncrementOp()) return nullptr;
  const auto* counter = llvm::dyn_cast<clang::VarDecl>(declaration->getSingleDecl());
  const bool counts = counter && counter->getType()->isIntegerType() &&
                      !counter->getType()->isBooleanType() && !counter->getType()->isReferenceType() &&
                      is_zero(counter->getInit());
  return counts && is_use_of(step->getSubExpr(), counter) ? counter : nullptr;
}

/// i < n, i != array.size()
bool reaches_the_end(const Unit& unit, const clang::Expr* condition, const clang::VarDecl* counter,
                     const ResizedArray& array) {
  const auto* op =
      condition ? llvm::dyn_cast<clang::BinaryOperator>(condition->IgnoreParenImpCasts()) : nullptr;
  if (!op || (op->getOpcode() != clang::BO_LT && op->getOpcode() != clang::BO_NE) ||
      !is_use_of(op->getLHS(), counter))
    return false;
  const std::string end = size_of(unit, op->getRHS());
  return end == array.name + ".size()" ||
         (!end.empty() && end == size_of(unit, array.size) && has_kept_its_value(unit, array));
}

/// The array whose element at the counter is written; null: something else is.
const clang::Expr* written_array(const clang::BinaryOperator* write, const clang::VarDecl* counter) {
  const auto* target = llvm::dyn_cast<clang::CXXOperatorCallExpr>(write->getLHS()->IgnoreParens());
  const bool is_element = target && target->getOperator() == clang::OO_Subscript && target->getNumArgs() == 2;
  return is_element && is_use_of(target->getArg(1), counter) ? target->getArg(0) : nullptr;
}

/// Each statement writes an element of the array or of a sister, one of them of the array.
bool writes_element(const Unit& unit, const clang::Stmt* body, const clang::VarDecl* counter,
                    const ResizedArray& array) {
  bool found = false;
  for (const clang::Stmt* statement : statements_of(body)) {
    const clang::BinaryOperator* write = assignment_of(unit, statement);
    const clang::Expr* target = write ? written_array(write, counter) : nullptr;
    const bool is_it = target && text_of(unit, target) == array.name;
    if (!target || (!is_it && !is_sister(unit, target, array.object))) return false;
    found |= is_it;
  }
  return found;
}

bool counts_through(const Unit& unit, const clang::ForStmt* loop, const ResizedArray& array) {
  const clang::VarDecl* counter = counter_of(loop);
  return counter && reaches_the_end(unit, loop->getCond(), counter, array) &&
         !mentions(array.name, counter->getName()) &&
         !mentions(text_of(unit, array.size), counter->getName()) &&
         writes_element(unit, loop->getBody(), counter, array);
}

bool ranges_over(const Unit& unit, const clang::CXXForRangeStmt* loop, const ResizedArray& array) {
  const std::vector<const clang::Stmt*> statements = statements_of(loop->getBody());
  const clang::BinaryOperator* write = statements.size() == 1 ? assignment_of(unit, statements[0]) : nullptr;
  const clang::VarDecl* element = loop->getLoopVariable();
  return write && element->getType()->isLValueReferenceType() && !loop->getInit() &&
         text_of(unit, loop->getRangeInit()) == array.name && is_use_of(write->getLHS(), element);
}

}  // namespace

bool resizes_sister(const Unit& unit, const clang::Stmt* statement, const clang::Expr* array) {
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(statement);
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  return method && method->getIdentifier() && method->getName() == "resize" && written_arguments(call) == 1 &&
         is_sister(unit, call->getImplicitObjectArgument(), array) &&
         NumberValues(unit, Calls::sizes).is_number(call->getArg(0));
}

bool writes_each_element(const Unit& unit, const clang::Stmt* statement, const ResizedArray& array) {
  if (const auto* loop = llvm::dyn_cast<clang::ForStmt>(statement)) return counts_through(unit, loop, array);
  const auto* loop = llvm::dyn_cast<clang::CXXForRangeStmt>(statement);
  return loop && ranges_over(unit, loop, array);
}

}  // namespace tzc::rewriter
