// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/number_values.h"

#include <llvm/ADT/StringExtras.h>

#include "facts/syntax/calls.h"
#include "facts/syntax/known_functions.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

/// A pointer to bytes may be one to such a class, and then its fields are elements: reinterpret_cast<Header*>(&frame.data[0])->rows.
bool may_lie_in_bytes(const clang::FieldDecl* field) {
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent());
  return !record || record->isTriviallyCopyable();
}

/// Its own object, or a parameter of a type that no port changes: std::vector<float>&. Other references, what is deduced and what a
/// typedef names may become the ported array.
bool is_stock_vector(const clang::VarDecl* variable) {
  clang::QualType type = variable->getType();
  if (!type->isReferenceType()) return true;
  if (!llvm::isa<clang::ParmVarDecl>(variable)) return false;
  type = type.getNonReferenceType();
  if (const auto* elaborated = llvm::dyn_cast<clang::ElaboratedType>(type.getTypePtr()))
    type = elaborated->getNamedType();
  return llvm::isa<clang::TemplateSpecializationType>(type.getTypePtr());
}

/// std::exchange(i, n)
bool may_change_arguments(const clang::FunctionDecl* function) {
  return llvm::any_of(function->parameters(), [](const clang::ParmVarDecl* parameter) {
    const clang::QualType type = parameter->getType();
    return type->isReferenceType() && !type.getNonReferenceType().isConstQualified();
  });
}

/// frame.elemSize(), text.size(): it tells of an object, and reads nothing that the object points to.
bool is_description(const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method || !method->getIdentifier() || !method->isConst() || call->getNumArgs() != 0 ||
      !call->isPRValue())
    return false;
  const llvm::StringRef name = method->getName();
  if (method->isInStdNamespace()) return name == "size" || name == "length" || name == "empty";
  return always_returns(qualified_name_of(method));
}

}  // namespace

bool is_plain_number(clang::QualType type) {
  return type->isArithmeticType() && !type.isVolatileQualified();
}

/// Part of an object that a name, and no pointer, leads to, or of an element of such an array.
bool NumberValues::is_object(const clang::Expr* expr) const {
  expr = expr->IgnoreParenImpCasts();
  if (llvm::isa<clang::CXXThisExpr>(expr) || is_element(expr)) return true;
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr))
    return llvm::isa<clang::VarDecl>(reference->getDecl()) &&
           !reference->getDecl()->getType()->isReferenceType();
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  return member && llvm::isa<clang::FieldDecl>(member->getMemberDecl()) &&
         !member->getMemberDecl()->getType()->isReferenceType() && is_object(member->getBase()) &&
         (!member->isArrow() || llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts()));
}

/// Another object than any element or array of a ported message.
bool NumberValues::is_other_array(const clang::Expr* expr) const {
  expr = expr->IgnoreParenImpCasts();
  const clang::QualType type = expr->getType().getCanonicalType();
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  const std::string name = record ? qualified_name_of(record) : std::string();
  if (!type->isConstantArrayType() && name != "std::vector" && name != "std::array") return false;
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  if (variable) return name == "std::vector" ? is_stock_vector(variable) : is_object(expr);
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  const auto* field = member ? llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl()) : nullptr;
  const auto* owner = field ? llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent()) : nullptr;
  return owner && !message_of(owner) && is_object(expr);
}

/// values[i]
bool NumberValues::is_element(const clang::Expr* expr) const {
  if (const auto* subscript = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr))
    return is_other_array(subscript->getBase()) && is_number(subscript->getIdx());
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr);
  return op && op->getOperator() == clang::OO_Subscript && op->getNumArgs() == 2 &&
         is_other_array(op->getArg(0)) && is_number(op->getArg(1));
}

/// values.size()
bool NumberValues::is_size(const clang::CXXMemberCallExpr* call) const {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  return method && method->getIdentifier() && method->getName() == "size" && call->getNumArgs() == 0 &&
         is_other_array(call->getImplicitObjectArgument());
}

/// std::sin(angle): it comes back, and what it is given leads nowhere.
bool NumberValues::is_call(const clang::CallExpr* call) const {
  const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (member && is_size(member)) return true;
  const clang::FunctionDecl* callee = call->getDirectCallee();
  if (calls_ == Calls::sizes || !callee || llvm::isa<clang::CXXOperatorCallExpr>(call) ||
      !calls_no_package_code(unit_, callee, {call->getArgs(), call->getNumArgs()}))
    return false;
  if (member) return is_description(member) && is_path(member->getImplicitObjectArgument());
  return comes_back(callee) && !may_change_arguments(callee) &&
         llvm::all_of(call->arguments(), [&](const clang::Expr* argument) { return is_number(argument); });
}

bool NumberValues::is_field(const clang::MemberExpr* member) const {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(member->getMemberDecl());
  return field && (is_object(member) || (!may_lie_in_bytes(field) && is_path(member)));
}

bool NumberValues::is_path(const clang::Expr* expr) const {
  expr = expr->IgnoreParenImpCasts();
  if (llvm::isa<clang::CXXThisExpr>(expr)) return true;
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr))
    return llvm::isa<clang::VarDecl>(name->getDecl());
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr))
    return llvm::isa<clang::FieldDecl>(member->getMemberDecl()) && is_path(member->getBase());
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr))
    return op->getOpcode() == clang::UO_Deref && is_path(op->getSubExpr());
  const auto* call = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr);
  const clang::FunctionDecl* follows = call ? call->getDirectCallee() : nullptr;
  return follows &&
         (call->getOperator() == clang::OO_Arrow ||
          (call->getOperator() == clang::OO_Star && call->getNumArgs() == 1)) &&
         calls_no_package_code(unit_, follows, {call->getArgs(), call->getNumArgs()}) &&
         is_path(call->getArg(0));
}

bool NumberValues::is_number(const clang::Expr* expr) const {
  if (const auto* temporary = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr))
    return is_number(temporary->getSubExpr());
  if (!is_plain_number(expr->getType())) return false;
  if (const auto* paren = llvm::dyn_cast<clang::ParenExpr>(expr)) return is_number(paren->getSubExpr());
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expr)) return is_number(cast->getSubExpr());
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr))
    return op->isArithmeticOp() && !op->isIncrementDecrementOp() && is_number(op->getSubExpr());
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(expr))
    return !op->isAssignmentOp() && is_number(op->getLHS()) && is_number(op->getRHS());
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expr))
    return is_number(choice->getCond()) && is_number(choice->getTrueExpr()) &&
           is_number(choice->getFalseExpr());
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr))
    return llvm::isa<clang::EnumConstantDecl>(reference->getDecl()) || is_object(expr);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return is_field(member);
  if (is_element(expr)) return true;
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return is_call(call);
  return llvm::isa<clang::IntegerLiteral, clang::FloatingLiteral, clang::CharacterLiteral,
                   clang::CXXBoolLiteralExpr>(expr);
}

std::optional<std::string> constant_integer(const Unit& unit, const clang::Expr* expr) {
  clang::Expr::EvalResult value;
  if (expr->isValueDependent() || !expr->getType()->isIntegerType() ||
      !expr->EvaluateAsInt(value, unit.ast()))
    return {};
  return llvm::toString(value.Val.getInt(), 10);
}

}  // namespace tzc::rewriter
