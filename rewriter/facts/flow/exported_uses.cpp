// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/exported_uses.h"

#include <clang/AST/Attr.h>
#include <clang/AST/DeclFriend.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/message_parts.h"
#include "facts/syntax/message_type.h"
#include "parse/names.h"

namespace tzc::rewriter {
namespace {

/// The class that a friend declaration names, or the template that it is made of; null: another thing.
const clang::CXXRecordDecl* class_of(const clang::FriendDecl* declaration) {
  const clang::TypeSourceInfo* type = declaration->getFriendType();
  const clang::CXXRecordDecl* record = type ? type->getType()->getAsCXXRecordDecl() : nullptr;
  const auto* made = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
  return made ? made->getSpecializedTemplate()->getTemplatedDecl() : record;
}

/// A class of a library, which is complete before it is named, knows nothing of the package.
bool is_of_library(const Unit& unit, const clang::FriendDecl* declaration) {
  const clang::CXXRecordDecl* record = class_of(declaration);
  return record && record->hasDefinition() && !unit.source.in_package(record->getDefinition()->getLocation());
}

std::string usr_of_friend(const clang::FriendDecl* declaration) {
  if (const clang::CXXRecordDecl* record = class_of(declaration)) return usr_of(record);
  const clang::NamedDecl* named = declaration->getFriendDecl();
  if (const auto* any = llvm::dyn_cast_or_null<clang::ClassTemplateDecl>(named))
    return usr_of(any->getTemplatedDecl());
  if (const auto* any = llvm::dyn_cast_or_null<clang::FunctionTemplateDecl>(named))
    return usr_of(any->getTemplatedDecl());
  return named ? usr_of(named) : "";
}

/// What the port changes the type of.
bool may_change(const Unit& unit, clang::QualType type) {
  return type->isDependentType() || type->isUndeducedType() || type->isPointerType() ||
         is_stock_or_twin_array(type) || carried_by(type, unit.rules);
}

bool is_dependent(clang::QualType type) {
  return type->isDependentType() || type->isUndeducedType();
}

/// The right side of an assignment to the expression; null: it is another one's, or none.
const clang::Expr* assigned_to(const clang::Expr* target, const clang::Expr* assignment) {
  const clang::Expr *left = nullptr, *right = nullptr;
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(assignment); op && op->isAssignmentOp())
    left = op->getLHS(), right = op->getRHS();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(assignment); op && op->isAssignmentOp())
    left = op->getArg(0), right = op->getArg(1);
  return left && left->IgnoreParenImpCasts() == target->IgnoreParenImpCasts() ? right : nullptr;
}

/// nh.advertise<M>("image", 1): of a class that no user chooses, so the port makes it what it makes of others.
bool is_advertise(const clang::Expr* expr) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr->IgnoreUnlessSpelledInSource());
  const auto* callee = call ? llvm::dyn_cast<clang::UnresolvedMemberExpr>(call->getCallee()) : nullptr;
  return callee && !callee->getBaseType()->isDependentType() &&
         callee->getMemberName().getAsString().rfind("advertise", 0) == 0;
}

/// Goes up from a mention through what leads on to another part of the same thing.
class Climb {
 public:
  Climb(const Unit& unit, const clang::FunctionDecl* around) : unit_(unit), around_(around) {}

  bool is_given_away(const clang::Expr* mention) {
    at_ = mention;
    for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *mention)) {
      if (const auto* variable = node.get<clang::VarDecl>()) return is_dependent(variable->getType());
      const auto* stmt = node.get<clang::Stmt>();
      const Step step = stmt ? step_to(stmt) : Step::stays;
      if (step != Step::leads_on) return step == Step::leaves;
      at_ = llvm::cast<clang::Expr>(stmt);
    }
    return false;
  }

 private:
  enum class Step { leads_on, stays, leaves };

  Step step_to(const clang::Stmt* stmt) const {
    if (llvm::isa<clang::ReturnStmt>(stmt))
      return is_dependent(around_->getDeclaredReturnType()) ? Step::leaves : Step::stays;
    const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
    if (!expr) return Step::stays;
    if (is_implicit_wrapper(expr) || is_member_of_it(expr) || llvm::isa<clang::UnaryOperator>(expr))
      return leads_on_if_changed(expr);
    const clang::Expr* assigned = assigned_to(at_, expr);
    if (assigned && is_advertise(assigned)) return Step::stays;
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return step_to_call(call);
    if (llvm::isa<clang::AbstractConditionalOperator>(expr)) return leads_on_if_changed(expr);
    return expr->isTypeDependent() ? Step::leaves : Step::stays;
  }

  /// A member function of it, or of its array, is called; or it is given to a function.
  Step step_to_call(const clang::CallExpr* call) const {
    const bool is_callee = call->getCallee()->IgnoreParenImpCasts() == at_->IgnoreParenImpCasts();
    if (is_callee && !is_dependent(call->getType())) return leads_on_if_changed(call);
    if (is_callee) return Step::leads_on;
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
    if (op && op->getOperator() == clang::OO_Subscript && !op->isTypeDependent())
      return leads_on_if_changed(op);
    return call->getDirectCallee() ? Step::stays : Step::leaves;
  }

  bool is_member_of_it(const clang::Expr* expr) const {
    return llvm::isa<clang::MemberExpr, clang::CXXDependentScopeMemberExpr, clang::UnresolvedMemberExpr>(
        expr);
  }

  /// image.width is a number, whatever the image's type is.
  Step leads_on_if_changed(const clang::Expr* expr) const {
    const bool is_function = expr->getType()->isSpecificBuiltinType(clang::BuiltinType::BoundMember);
    return is_function || may_change(unit_, expr->getType()) ? Step::leads_on : Step::stays;
  }

  const Unit& unit_;
  const clang::FunctionDecl* around_;
  const clang::Expr* at_ = nullptr;
};

}  // namespace

std::set<std::string> friends_of(const Unit& unit, const clang::Decl* member) {
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(member->getDeclContext());
  std::set<std::string> friends;
  if (!record || !unit.exports(record->getLocation())) return friends;
  for (const clang::FriendDecl* declaration : record->friends())
    if (!is_of_library(unit, declaration)) friends.insert(usr_of_friend(declaration));
  return friends;
}

namespace {

/// extern "C" says nothing of members, nor of what only its own file can name.
bool has_c_linkage(const clang::DeclaratorDecl* decl) {
  if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(decl)) return function->isExternC();
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  return variable && variable->isExternC();
}

/// Of another declaration of the same, too: a header has it, the definition need not repeat it.
bool names_its_symbol(const clang::DeclaratorDecl* decl) {
  return llvm::any_of(decl->redecls(), [](const clang::Decl* declaration) {
    return declaration->hasAttr<clang::AsmLabelAttr>() || declaration->hasAttr<clang::AliasAttr>();
  });
}

}  // namespace

bool has_symbol_without_types(const clang::DeclaratorDecl* decl) {
  return has_c_linkage(decl) || names_its_symbol(decl);
}

bool is_given_to_users(const Unit& unit, const clang::Expr* mention) {
  const clang::FunctionDecl* around = enclosing_function(unit.ast(), *mention);
  if (!around || !around->isDependentContext() || !unit.exports(around->getLocation())) return false;
  return Climb(unit, around).is_given_away(mention);
}

}  // namespace tzc::rewriter
