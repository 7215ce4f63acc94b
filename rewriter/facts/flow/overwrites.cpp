// SPDX-License-Identifier: BSD-3-Clause
// `image.data.resize(n)` fills with zeros. That is left out only where what follows provably writes all n
// elements:
//   image.data.resize(n);
//   memcpy(&image.data[0], pixels, n);      // or of image.data.size() bytes, or std::fill over begin() ...
//                                           // end(), or a loop (element_loops.cpp)
#include "facts/flow/overwrites.h"

#include "facts/flow/element_loops.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/known_functions.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/number_values.h"
#include "facts/syntax/package_types.h"

namespace tzc::rewriter {
namespace {

/// A number that the type may not hold.
bool may_change_value(const Unit& unit, const clang::ExplicitCastExpr* cast) {
  const clang::QualType from = cast->getSubExprAsWritten()->getType(), to = cast->getType();
  if (!from->isArithmeticType() || !to->isArithmeticType()) return false;
  return !from->isIntegerType() || !to->isIntegerType() ||
         unit.ast().getTypeSize(to) < unit.ast().getTypeSize(from);
}

const clang::Expr* bare(const Unit& unit, const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expr);
  return cast && !may_change_value(unit, cast) ? bare(unit, cast->getSubExprAsWritten()) : expr;
}

std::string text_of(const Unit& unit, const clang::Expr* expr) {
  return unit.squeezed(bare(unit, expr));
}

/// Of a number that the compiler knows, its value: a macro of the same name may have another one by now.
std::string size_of(const Unit& unit, const clang::Expr* expr) {
  return constant_integer(unit, expr).value_or(text_of(unit, expr));
}

/// &x[0], x.data(), &x.front(): where the array begins.
bool is_begin_of(const Unit& unit, const clang::Expr* expr, const std::string& array) {
  const std::string text = text_of(unit, expr);
  return text == "&" + array + "[0]" || text == array + ".data()" || text == "&" + array + ".front()" ||
         text == "&(" + array + "[0])";
}

bool is_all_bytes(const Unit& unit, const clang::Expr* count, const std::string& array,
                  const std::string& size, bool bytes) {
  const std::string text = size_of(unit, count);
  return bytes && !text.empty() && (text == size || text == array + ".size()");
}

/// Only constants have the same value a few statements later.
bool is_stable(const Unit& unit, const clang::Expr* size) {
  if (constant_integer(unit, size)) return true;
  const clang::Expr* expr = bare(unit, size);
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  return variable && variable->getType().isConstQualified();
}

/// std::string, std::vector<float>: its end runs no code of the package, and shows nothing.
bool ends_quietly(const Unit& unit, clang::QualType type) {
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return record && is_owner_class(qualified_name_of(record)) && !involves_package(unit, type);
}

bool is_quiet_call(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  return callee && comes_back(callee) &&
         calls_no_package_code(unit, callee, {call->getArgs(), call->getNumArgs()});
}

/// Whether an expression, its operands aside, only computes. What is not named here may throw (typeid(*p), new int[n]), leave the function
/// by a statement (({ return; })), change something, or run code at its end.
bool only_computes(const Unit& unit, const clang::Stmt* stmt) {
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(stmt)) return !op->isAssignmentOp();
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(stmt))
    return !op->isIncrementDecrementOp() && op->getOpcode() != clang::UO_Coawait;
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) return is_quiet_call(unit, call);
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return made->getConstructor()->isTrivial();
  if (const auto* temporary = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(stmt))
    return ends_quietly(unit, temporary->getType());
  // To a pointer, it gives null where the object is of another class; to a reference, it throws.
  if (llvm::isa<clang::CXXDynamicCastExpr>(stmt)) return llvm::cast<clang::Expr>(stmt)->isPRValue();
  return llvm::isa<clang::DeclRefExpr, clang::MemberExpr, clang::CXXThisExpr, clang::CastExpr,
                   clang::ParenExpr, clang::FullExpr, clang::MaterializeTemporaryExpr,
                   clang::AbstractConditionalOperator, clang::OpaqueValueExpr, clang::ArraySubscriptExpr,
                   clang::CXXDefaultArgExpr, clang::SubstNonTypeTemplateParmExpr, clang::InitListExpr,
                   clang::UnaryExprOrTypeTraitExpr, clang::ImplicitValueInitExpr,
                   clang::CXXScalarValueInitExpr, clang::CXXNullPtrLiteralExpr, clang::CXXBoolLiteralExpr,
                   clang::IntegerLiteral, clang::FloatingLiteral, clang::CharacterLiteral,
                   clang::StringLiteral>(stmt);
}

/// Whether evaluating it twice gives the same, cannot leave the function before the array is written, which would show what
/// was not written, and runs no code that may read the array by another name.
bool is_plain_value(const Unit& unit, const clang::Stmt* stmt) {
  if (!stmt) return true;
  if (!only_computes(unit, stmt)) return false;
  if (const auto* argument = llvm::dyn_cast<clang::CXXDefaultArgExpr>(stmt))
    return is_plain_value(unit, argument->getExpr());
  return llvm::all_of(stmt->children(),
                      [&](const clang::Stmt* child) { return is_plain_value(unit, child); });
}

/// A call that only leads on: ->, [], a container's front().
bool is_step_of_name(const clang::CallExpr* call) {
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call))
    return op->getOperator() == clang::OO_Arrow || op->getOperator() == clang::OO_Star ||
           op->getOperator() == clang::OO_Subscript;
  const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::CXXMethodDecl* method = member ? member->getMethodDecl() : nullptr;
  if (!method || !method->getIdentifier()) return false;
  return method->isConst() || method->getName() == "front" || method->getName() == "back";
}

/// Whether what is written leads to the same object each time: frames_[rand() % 2] does not.
bool is_steady_name(const Unit& unit, const clang::Stmt* stmt) {
  if (!is_plain_value(unit, stmt)) return false;
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(stmt);
  if (call && !is_step_of_name(call)) return false;
  return !stmt || llvm::all_of(stmt->children(),
                               [&](const clang::Stmt* child) { return is_steady_name(unit, child); });
}

/// table[frame.data[0]]: a number that is read on the way may be an element.
bool reads_elements(const NumberValues& values, const clang::Stmt* stmt) {
  const auto* expr = llvm::dyn_cast_or_null<clang::Expr>(stmt);
  if (expr && expr->isPRValue() && expr->getType()->isArithmeticType()) return !values.is_number(expr);
  return stmt && llvm::any_of(stmt->children(),
                              [&](const clang::Stmt* child) { return reads_elements(values, child); });
}

/// What memcpy or memset writes: elements that are not the array's by its own name (by another, memcpy would be given memory that
/// overlaps), or a number.
bool are_others(const Unit& unit, const clang::Expr* written, const std::string& array) {
  const std::string text = unit.squeezed(written);
  return is_plain_value(unit, written) && !reads_elements({unit, Calls::known}, written) && !text.empty() &&
         text.find(array) == std::string::npos;
}

bool overwrites(const Unit& unit, const clang::Stmt* statement, const std::string& array,
                const std::string& size, bool bytes, bool stable) {
  if (const auto* full = llvm::dyn_cast<clang::ExprWithCleanups>(statement)) statement = full->getSubExpr();
  const auto* call = llvm::dyn_cast<clang::CallExpr>(statement);
  const clang::FunctionDecl* function = call ? call->getDirectCallee() : nullptr;
  if (!function || call->getNumArgs() < 3) return false;
  const std::string name = qualified_name_of(function);
  if (name == "memcpy" || name == "std::memcpy" || name == "memset" || name == "std::memset")
    return is_begin_of(unit, call->getArg(0), array) &&
           is_all_bytes(unit, call->getArg(2), array, stable ? size : "\n", bytes) &&
           are_others(unit, call->getArg(1), array);
  return name == "std::fill" && text_of(unit, call->getArg(0)) == array + ".begin()" &&
         text_of(unit, call->getArg(1)) == array + ".end()" &&
         NumberValues(unit, Calls::known).is_number(call->getArg(2));
}

/// frames[index].data: an assignment may lead the name to another array.
bool depends_on_number(const clang::Stmt* name) {
  const auto* expr = llvm::dyn_cast_or_null<clang::Expr>(name);
  if (expr && expr->getType()->isArithmeticType()) return true;
  return name && llvm::any_of(name->children(), depends_on_number);
}

/// A number is assigned, none that is read from the array, and nothing on the way leaves the function or makes the array's name
/// another one's.
bool is_harmless(const Unit& unit, const clang::Stmt* statement, const clang::Expr* array) {
  const auto* op = llvm::dyn_cast<clang::BinaryOperator>(statement);
  const NumberValues values(unit, Calls::known);
  return op && op->isAssignmentOp() && is_plain_number(op->getLHS()->getType()) &&
         values.is_path(op->getLHS()) && values.is_number(op->getRHS()) && !depends_on_number(array);
}

/// A size that a macro begins is compared by its value only.
std::optional<Place> size_place(const Unit& unit, const clang::CXXMemberCallExpr* resize) {
  const bool is_known = constant_integer(unit, resize->getArg(0)).has_value();
  return is_known ? argument_place(unit, resize, 0) : unit.source.place(resize->getArg(0)->getSourceRange());
}

}  // namespace

std::optional<Place> zero_fill_place(const Unit& unit, const clang::CXXMemberCallExpr* resize) {
  std::optional<Place> behind = written_arguments(resize) == 1 ? size_place(unit, resize) : std::nullopt;
  if (behind) behind->begin = behind->end;
  return behind;
}

std::optional<Change> without_zero_fill(const Unit& unit, const clang::CXXMemberCallExpr* resize) {
  const auto* block = parent_as<clang::CompoundStmt>(unit.ast(), *resize);
  const std::optional<Place> behind = zero_fill_place(unit, resize);
  if (!block || !behind) return {};
  const clang::Expr* object = resize->getImplicitObjectArgument();
  const std::string array = unit.squeezed(object);
  if (array.empty() || !is_steady_name(unit, object)) return {};
  const std::string size = size_of(unit, resize->getArg(0));
  const auto* vector = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(
      object->getType().getCanonicalType()->getAsCXXRecordDecl());
  const bool bytes = vector && unit.ast().getTypeSize(vector->getTemplateArgs()[0].getAsType()) == 8;
  bool behind_it = false, is_fresh = false;
  for (const clang::Stmt* statement : block->body()) {
    const ResizedArray resized{array, object, resize->getArg(0), is_fresh};
    if (behind_it && (overwrites(unit, statement, array, size, bytes, is_stable(unit, resize->getArg(0))) ||
                      writes_each_element(unit, statement, resized)))
      return Change{*behind, ", tzc::uninitialized", uninitialized_rule, {}};
    const bool is_sister = resizes_sister(unit, statement, resized);
    if (behind_it && !is_sister && !is_harmless(unit, statement, object)) return {};
    behind_it |= statement == resize;
    is_fresh = statement == resize || (is_fresh && is_sister);
  }
  return {};
}

}  // namespace tzc::rewriter
