// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/bound_calls.h"

#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

const clang::DeclRefExpr* named_function(const Unit& unit, const clang::Expr* expr) {
  expr = expr->IgnoreImplicit()->IgnoreParenImpCasts();
  if (const auto* address = llvm::dyn_cast<clang::UnaryOperator>(expr))
    if (address->getOpcode() == clang::UO_AddrOf) expr = address->getSubExpr()->IgnoreParenImpCasts();
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  const auto* function = name ? llvm::dyn_cast<clang::FunctionDecl>(name->getDecl()) : nullptr;
  return function && unit.declares(function) ? name : nullptr;
}

bool is_thread(const clang::CXXRecordDecl* record) {
  static const std::set<std::string> names = {"std::thread", "std::jthread", "boost::thread"};
  return record && names.count(qualified_name_of(record)) != 0;
}

/// threads.emplace_back(function, a)
bool emplaces_thread(const clang::CallExpr* call) {
  const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::CXXMethodDecl* method = member ? member->getMethodDecl() : nullptr;
  if (!method || method->getNameAsString().rfind("emplace", 0) != 0) return false;
  const auto* container = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(method->getParent());
  if (!container || container->getTemplateArgs().size() == 0) return false;
  const clang::TemplateArgument& held = container->getTemplateArgs()[0];
  return held.getKind() == clang::TemplateArgument::Type && is_thread(held.getAsType()->getAsCXXRecordDecl());
}

bool binds(const clang::CallExpr* call) {
  static const std::set<std::string> names = {"std::bind", "boost::bind", "std::async", "boost::async"};
  const clang::FunctionDecl* function = call->getDirectCallee();
  return function && (names.count(qualified_name_of(function)) != 0 || emplaces_thread(call));
}

}  // namespace

std::optional<BoundCall> bound_call(const Unit& unit, const clang::Expr* expr) {
  llvm::ArrayRef<const clang::Expr*> arguments;
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr); call && binds(call))
    arguments = {call->getArgs(), call->getNumArgs()};
  else if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
           made && is_thread(made->getConstructor()->getParent()))
    arguments = {made->getArgs(), made->getNumArgs()};
  // std::async may be given a policy first.
  for (unsigned i = 0; i < arguments.size() && i < 2; ++i) {
    const clang::DeclRefExpr* name = named_function(unit, arguments[i]);
    if (!name) continue;
    const auto* function = llvm::cast<clang::FunctionDecl>(name->getDecl());
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
    return BoundCall{function, name, arguments, i + (method && !method->isStatic() ? 2 : 1)};
  }
  return {};
}

}  // namespace tzc::rewriter
