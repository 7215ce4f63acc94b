// SPDX-License-Identifier: BSD-3-Clause
// Loops that write every element of an array that was just resized:
//   for (int i = 0; i < n; ++i) scan.ranges[i] = values[i];
//   for (float& range : scan.ranges) range = 0.1f;
// A loop may write the sister arrays of the same message, too, and compute in numbers of its own:
//   for (int i = 0; i < n; ++i) {
//     float range = echoes[i].time * speed;
//     if (range > limit_) range = limit_;
//     scan.ranges[i] = range;
//   }
// What is written is a number that is no element of the array (number_values.h).
#include "facts/flow/element_loops.h"

#include <clang/AST/ExprCXX.h>
#include <clang/AST/StmtCXX.h>
#include <llvm/ADT/SmallPtrSet.h>

#include <algorithm>
#include <cstdint>

#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"
#include "facts/syntax/number_values.h"

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

/// Whether a vector of so many elements can be: another size may be too many, and std::length_error would show whoever catches it
/// what is not written yet. The array has its own size by now, in memory that is there, and a sister's elements are not so much
/// larger that as many of them would pass its limit. A number that the compiler knows is compared with no limit but a modest one.
bool is_known_to_fit(const Unit& unit, const clang::Expr* size, const ResizedArray& array) {
  constexpr std::uint64_t modest = std::uint64_t{1} << 32;
  clang::Expr::EvalResult value;
  if (!size->isValueDependent() && size->EvaluateAsInt(value, unit.ast()))
    return !value.Val.getInt().isNegative() && value.Val.getInt().getLimitedValue() <= modest;
  const std::string text = text_of(unit, size);
  return !text.empty() && text == text_of(unit, array.size) && has_kept_its_value(unit, array);
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

/// The loop's own element of the array or of a sister.
class LoopElement {
 public:
  /// variable: the counter, or the reference that a loop over the array declares
  LoopElement(const Unit& unit, const ResizedArray& array, const clang::VarDecl* variable)
      : unit_(unit), array_(array), variable_(variable) {}

  bool is_it(const clang::Expr* target) const {
    if (is_reference()) return is_use_of(target, variable_);
    const clang::Expr* written = array_of(target);
    return written && text_of(unit_, written) == array_.name;
  }
  bool is_sisters(const clang::Expr* target) const {
    const clang::Expr* written = is_reference() ? nullptr : array_of(target);
    return written && is_sister(unit_, written, array_.object);
  }

 private:
  bool is_reference() const { return variable_->getType()->isReferenceType(); }
  /// Of array[counter], the array.
  const clang::Expr* array_of(const clang::Expr* target) const {
    const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(target->IgnoreParens());
    const bool is_element = call && call->getOperator() == clang::OO_Subscript && call->getNumArgs() == 2;
    return is_element && is_use_of(call->getArg(1), variable_) ? call->getArg(0) : nullptr;
  }

  const Unit& unit_;
  const ResizedArray& array_;
  const clang::VarDecl* variable_;
};

/// What a loop does in each of its rounds: it computes with numbers, and gives the element its value.
class LoopBody {
 public:
  LoopBody(const Unit& unit, const ResizedArray& array, const clang::VarDecl* variable)
      : array_(array), element_(unit, array, variable), values_(unit, Calls::known) {}

  /// Whether each way through it writes the element, and nothing else happens.
  bool writes(const clang::Stmt* body) { return of(body) == Effect::written; }

 private:
  enum class Effect { other, computed, written };

  Effect of(const clang::Stmt* statement) {
    if (const auto* full = llvm::dyn_cast_or_null<clang::ExprWithCleanups>(statement))
      statement = full->getSubExpr();
    if (!statement) return Effect::other;
    if (const auto* block = llvm::dyn_cast<clang::CompoundStmt>(statement)) return of_block(block);
    if (const auto* choice = llvm::dyn_cast<clang::IfStmt>(statement)) return of_choice(choice);
    if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(statement))
      return of_declaration(declaration);
    const auto* op = llvm::dyn_cast<clang::BinaryOperator>(statement);
    return op && op->isAssignmentOp() && values_.is_number(op->getRHS()) ? of_assignment(op) : Effect::other;
  }

  Effect of_block(const clang::CompoundStmt* block) {
    Effect whole = Effect::computed;
    for (const clang::Stmt* statement : block->body()) {
      const Effect effect = of(statement);
      if (effect == Effect::other) return effect;
      whole = std::max(whole, effect);
    }
    return whole;
  }

  Effect of_choice(const clang::IfStmt* choice) {
    if (choice->getInit() || choice->getConditionVariable() || !values_.is_number(choice->getCond()))
      return Effect::other;
    const Effect yes = of(choice->getThen());
    const Effect no = choice->getElse() ? of(choice->getElse()) : Effect::computed;
    return std::min(yes, no);
  }

  Effect of_declaration(const clang::DeclStmt* declaration) {
    for (const clang::Decl* declared : declaration->decls()) {
      const auto* variable = llvm::dyn_cast<clang::VarDecl>(declared);
      if (!variable || !is_own_number(variable)) return Effect::other;
      own_.insert(variable);
    }
    return Effect::computed;
  }

  /// It also hides no name that leads to the array.
  bool is_own_number(const clang::VarDecl* variable) const {
    return variable->hasLocalStorage() && is_plain_number(variable->getType()) &&
           (!variable->getInit() || values_.is_number(variable->getInit())) &&
           !mentions(array_.name, variable->getName());
  }

  Effect of_assignment(const clang::BinaryOperator* op) const {
    const bool is_plain = op->getOpcode() == clang::BO_Assign && is_plain_number(op->getLHS()->getType());
    if (is_plain && element_.is_it(op->getLHS())) return Effect::written;
    if (is_plain && element_.is_sisters(op->getLHS())) return Effect::computed;
    const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(op->getLHS()->IgnoreParens());
    return name && own_.count(name->getDecl()) ? Effect::computed : Effect::other;
  }

  const ResizedArray& array_;
  const LoopElement element_;
  const NumberValues values_;
  llvm::SmallPtrSet<const clang::ValueDecl*, 4> own_;  ///< the numbers that the body declares
};

bool counts_through(const Unit& unit, const clang::ForStmt* loop, const ResizedArray& array) {
  const clang::VarDecl* counter = counter_of(loop);
  return counter && reaches_the_end(unit, loop->getCond(), counter, array) &&
         !mentions(array.name, counter->getName()) &&
         !mentions(text_of(unit, array.size), counter->getName()) &&
         LoopBody(unit, array, counter).writes(loop->getBody());
}

bool ranges_over(const Unit& unit, const clang::CXXForRangeStmt* loop, const ResizedArray& array) {
  const clang::VarDecl* element = loop->getLoopVariable();
  return element->getType()->isLValueReferenceType() && !loop->getInit() &&
         text_of(unit, loop->getRangeInit()) == array.name &&
         LoopBody(unit, array, element).writes(loop->getBody());
}

}  // namespace

bool resizes_sister(const Unit& unit, const clang::Stmt* statement, const ResizedArray& array) {
  const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(statement);
  const clang::CXXMethodDecl* method = call ? call->getMethodDecl() : nullptr;
  return method && method->getIdentifier() && method->getName() == "resize" && written_arguments(call) == 1 &&
         is_sister(unit, call->getImplicitObjectArgument(), array.object) &&
         is_known_to_fit(unit, call->getArg(0), array);
}

bool writes_each_element(const Unit& unit, const clang::Stmt* statement, const ResizedArray& array) {
  if (const auto* loop = llvm::dyn_cast<clang::ForStmt>(statement)) return counts_through(unit, loop, array);
  const auto* loop = llvm::dyn_cast<clang::CXXForRangeStmt>(statement);
  return loop && ranges_over(unit, loop, array);
}

}  // namespace tzc::rewriter
