// SPDX-License-Identifier: BSD-3-Clause
#include "facts/ast_walk.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include "parse/names.h"

namespace tzc::rewriter {

Ancestors::Iterator& Ancestors::Iterator::operator++() {
  const auto parents = ast_->getParents(node_);
  at_end_ = parents.empty();
  if (!at_end_) node_ = parents[0];
  return *this;
}

bool is_lambda(const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return method && method->getParent()->isLambda();
}

const clang::FunctionDecl* enclosing_function(clang::ASTContext& ast, const clang::Stmt& stmt) {
  for (const clang::DynTypedNode& node : ancestors(ast, stmt)) {
    if (const auto* function = node.get<clang::FunctionDecl>()) return function;
    if (const auto* lambda = node.get<clang::LambdaExpr>()) return lambda->getCallOperator();
  }
  return nullptr;
}

std::string enclosing_function_name(clang::ASTContext& ast, const clang::Stmt& stmt) {
  const clang::FunctionDecl* function = enclosing_function(ast, stmt);
  while (function && is_lambda(function)) {
    const auto* method = llvm::cast<clang::CXXMethodDecl>(function);
    const auto* outer = llvm::dyn_cast<clang::FunctionDecl>(method->getParent()->getDeclContext());
    if (!outer) break;
    function = outer;
  }
  return function ? qualified_name_of(function) : "";
}

std::string record_usr_of(const clang::FunctionDecl* function) {
  const clang::DeclContext* context = function;
  while (context && !context->isTranslationUnit()) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(context);
    if (method && !method->getParent()->isLambda())
      return method->isStatic() ? "" : usr_of(method->getParent());
    context = context->getParent();
  }
  return "";
}

bool is_implicit_wrapper(const clang::Stmt* stmt) {
  return llvm::isa<clang::ParenExpr, clang::ImplicitCastExpr, clang::FullExpr,
                   clang::MaterializeTemporaryExpr, clang::CXXBindTemporaryExpr>(stmt);
}

}  // namespace tzc::rewriter
