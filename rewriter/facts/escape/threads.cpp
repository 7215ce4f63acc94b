// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/threads.h"

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/known_functions.h"

namespace tzc::rewriter {

std::string place_name(const Unit& unit, const clang::Expr* expr) {
  const Location at = unit.location(expr->getBeginLoc());
  return at.file + ":" + std::to_string(at.line) + ":" + std::to_string(at.column);
}

std::string closure_name(const Unit& unit, const clang::LambdaExpr* lambda) {
  return "{" + place_name(unit, lambda) + "}";
}

bool is_closure(const std::string& code) {
  return code[0] == '{';
}

bool names_captured(const clang::Stmt* stmt) {
  if (!stmt) return false;
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(stmt);
  return (name && name->refersToEnclosingVariableOrCapture()) ||
         llvm::any_of(stmt->children(), names_captured);
}

const clang::LambdaExpr* ThreadCode::closure_around(const clang::Stmt* stmt) const {
  const clang::LambdaExpr* lambda = view_.lambda_around(stmt);
  while (lambda && is_called_here(lambda)) lambda = view_.lambda_around(lambda);
  return lambda;
}

std::string ThreadCode::around(const clang::Stmt* stmt) const {
  const clang::LambdaExpr* lambda = closure_around(stmt);
  return lambda ? closure_name(context_.unit, lambda) : usr_of(pattern_of(view_.function()));
}

bool ThreadCode::is_call_of(const clang::Stmt* call, const clang::Stmt* closure) const {
  const auto* op = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(call);
  return op && op->getOperator() == clang::OO_Call && op->getArg(0) == closure;
}

/// auto add = [&](float range) { ... }; add(1); add(2);
bool ThreadCode::is_only_called(const clang::VarDecl* variable, const clang::LambdaExpr* around) const {
  const clang::CXXRecordDecl* type = variable ? variable->getType()->getAsCXXRecordDecl() : nullptr;
  if (!type || !type->isLambda()) return false;
  return llvm::all_of(view_.uses(variable), [&](const clang::DeclRefExpr* use) {
    const clang::Stmt* inner = use;
    while (is_wrapping(view_.parent(inner))) inner = view_.parent(inner);
    return is_call_of(view_.parent(inner), inner) && view_.lambda_around(use) == around;
  });
}

/// std::for_each(std::execution::par, ...): several threads run what it is given.
static bool may_run_in_parallel(const clang::CallExpr* call) {
  return llvm::any_of(call->arguments(), [](const clang::Expr* argument) {
    const clang::CXXRecordDecl* type = argument->getType().getNonReferenceType()->getAsCXXRecordDecl();
    return type && qualified_name_of(type).find("execution::") != std::string::npos;
  });
}

bool ThreadCode::is_called_here(const clang::LambdaExpr* lambda) const {
  const clang::Stmt* inner = lambda;
  const clang::Stmt* around = view_.parent(lambda);
  const auto* copy = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(around);
  while (is_wrapping(around) || (copy && copy->getConstructor()->getParent() == lambda->getLambdaClass())) {
    inner = around;
    around = view_.parent(around);
    copy = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(around);
  }
  if (is_call_of(around, inner)) return true;
  if (const auto* declaration = llvm::dyn_cast_or_null<clang::DeclStmt>(around))
    return declaration->isSingleDecl() &&
           is_only_called(llvm::dyn_cast<clang::VarDecl>(declaration->getSingleDecl()),
                          view_.lambda_around(around));
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
  const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
  return callee && !may_run_in_parallel(call) && context_.keeping_of(callee, {}) != Keeping::unknown;
}

bool ThreadCode::hands_over(const clang::Stmt* stmt) const {
  if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt)) return !is_called_here(lambda);
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(stmt);
  if (!name || !context_.unit.declares(llvm::dyn_cast<clang::FunctionDecl>(name->getDecl()))) return false;
  const clang::Stmt* around = view_.parent(name);
  while (is_wrapping(around)) around = view_.parent(around);
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(around);
  return !call || call->getCalleeDecl() != name->getDecl();
}

}  // namespace tzc::rewriter
