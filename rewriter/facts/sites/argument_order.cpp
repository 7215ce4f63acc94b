// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/argument_order.h"

#include <set>

#include "facts/syntax/bodies.h"
#include "facts/syntax/calls.h"

namespace tzc::rewriter {
namespace {

constexpr int most_functions = 4;  // each of which returns what the next one returns

bool may_change(const Unit& unit, const clang::Stmt* code, int functions = 0);

/// ros::NodeHandle& node() { return nh_; }
bool only_returns(const Unit& unit, const clang::FunctionDecl* function, int functions) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  const clang::FunctionDecl* definition = shown_body(function);
  if ((method && method->isVirtual()) || functions == most_functions || !definition) return false;
  const auto* body = llvm::dyn_cast<clang::CompoundStmt>(definition->getBody());
  const auto* result =
      body && body->size() == 1 ? llvm::dyn_cast<clang::ReturnStmt>(body->body_front()) : nullptr;
  return result && !may_change(unit, result->getRetValue(), functions + 1);
}

bool call_may_change(const Unit& unit, const clang::CallExpr* call, int functions) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  return !function || (unit.declares(function) && !only_returns(unit, function, functions));
}

bool constructor_may_change(const Unit& unit, const clang::CXXConstructExpr* construct) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  return unit.declares(constructor) && !constructor->isImplicit() && !constructor->isDefaulted();
}

bool changes_by_itself(const clang::Stmt* code) {
  if (const auto* unary = llvm::dyn_cast<clang::UnaryOperator>(code)) return unary->isIncrementDecrementOp();
  if (const auto* binary = llvm::dyn_cast<clang::BinaryOperator>(code)) return binary->isAssignmentOp();
  return llvm::isa<clang::CXXThrowExpr, clang::CXXDeleteExpr, clang::CXXNewExpr, clang::StmtExpr>(code);
}

/// Whether evaluating it may change what another expression reads, or end in an exception of the package.
bool may_change(const Unit& unit, const clang::Stmt* code, int functions) {
  if (!code || llvm::isa<clang::LambdaExpr>(code)) return false;
  if (changes_by_itself(code)) return true;
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(code))
    if (call_may_change(unit, call, functions)) return true;
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(code))
    if (constructor_may_change(unit, construct)) return true;
  return llvm::any_of(code->children(),
                      [&](const clang::Stmt* part) { return may_change(unit, part, functions); });
}

/// A variable of the function that no other function can get at without being given it.
bool is_local_value(const clang::VarDecl* variable) {
  return variable->hasLocalStorage() && !variable->getType()->isReferenceType();
}

using Variables = std::set<const clang::VarDecl*>;

/// What a function object of a lambda expression may change besides what it is given.
void add_captured(const clang::VarDecl* closure, Variables& named) {
  const clang::CXXRecordDecl* type = closure->getType().getNonReferenceType()->getAsCXXRecordDecl();
  if (!type || !type->isLambda()) return;
  for (const clang::LambdaCapture& capture : type->captures())
    if (capture.capturesVariable())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(capture.getCapturedVar()))
        named.insert(variable);
}

void add_named(const clang::Stmt* code, Variables& named) {
  if (!code) return;
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(code)) {
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl())) {
      named.insert(variable);
      add_captured(variable, named);
    }
  }
  for (const clang::Stmt* part : code->children()) add_named(part, named);
}

Variables named_in(const clang::Expr* code) {
  Variables named;
  add_named(code, named);
  return named;
}

/// Whether its value depends on what the package may change meanwhile. `others`: that the other expression names.
bool reads(const Unit& unit, const clang::Stmt* code, const Variables& others) {
  if (!code || llvm::isa<clang::LambdaExpr>(code)) return false;
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(code)) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
    return variable && (!is_local_value(variable) || others.count(variable) != 0) &&
           !variable->getType().isConstQualified();
  }
  if (llvm::isa<clang::MemberExpr>(code) && !llvm::cast<clang::Expr>(code)->isBoundMemberFunction(unit.ast()))
    return !llvm::cast<clang::Expr>(code)->getType().isConstQualified();
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(code))
    if (!call->getDirectCallee() || unit.declares(call->getDirectCallee())) return true;
  return llvm::any_of(code->children(), [&](const clang::Stmt* part) { return reads(unit, part, others); });
}

/// An object that is the same whenever it is named.
bool is_name(const clang::Expr* expr) {
  expr = expr->IgnoreParenImpCasts();
  if (llvm::isa<clang::CXXThisExpr, clang::DeclRefExpr>(expr)) return true;
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  return member && llvm::isa<clang::FieldDecl>(member->getMemberDecl()) &&
         (!member->isArrow() || llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts())) &&
         is_name(member->getBase());
}

/// Through a pointer it is the one that the pointer's value names just then.
bool is_same_object(const Receiver& receiver) {
  return is_name(receiver.expr) &&
         (!receiver.pointer || llvm::isa<clang::CXXThisExpr>(receiver.expr->IgnoreParenImpCasts()));
}

/// An argument by reference is read only by the function.
bool reads_argument(const Unit& unit, const clang::CXXMemberCallExpr* call, unsigned index,
                    const Variables& others) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  const bool by_reference = function && index < function->getNumParams() &&
                            function->getParamDecl(index)->getType()->isReferenceType();
  const clang::Expr* argument = call->getArg(index);
  return !(by_reference && is_name(argument)) && reads(unit, argument, others);
}

}  // namespace

bool order_matters(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const Receiver receiver = receiver_of(call);
  const clang::Expr* object = receiver.expr;
  if (!object || is_same_object(receiver)) return false;
  const bool object_changes = may_change(unit, object);
  const Variables of_object = named_in(object);
  for (unsigned i = 0; i < written_arguments(call); ++i) {
    const clang::Expr* argument = call->getArg(i);
    const bool argument_changes = may_change(unit, argument);
    if (object_changes && (argument_changes || reads_argument(unit, call, i, of_object))) return true;
    if (argument_changes && reads(unit, object, named_in(argument))) return true;
  }
  return false;
}

}  // namespace tzc::rewriter
