// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/ast_walk.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include <algorithm>
#include <iterator>

#include "parse/names.h"

namespace tzc::rewriter {
namespace {

/// A list as written may have no type; what it initialises has.
bool is_written_place(const clang::DynTypedNode& node) {
  if (node.get<clang::CXXDefaultInitExpr>() || node.get<clang::CXXDefaultArgExpr>()) return false;
  const auto* list = node.get<clang::InitListExpr>();
  return !list || !list->getType()->isVoidType();
}

/// A list is around what is written in it, and around what that is converted to, which is what it holds.
bool holds(const clang::DynTypedNode& around, const clang::DynTypedNode& node) {
  const auto* list = around.get<clang::InitListExpr>();
  return !list || llvm::is_contained(list->inits(), node.get<clang::Expr>());
}

}  // namespace

std::optional<clang::DynTypedNode> written_parent(clang::ASTContext& ast, const clang::DynTypedNode& node) {
  const auto parents = ast.getParents(node);
  if (parents.empty()) return std::nullopt;
  const auto* written = std::find_if(parents.begin(), parents.end(), is_written_place);
  return written == parents.end() ? parents[0] : *written;
}

std::vector<clang::DynTypedNode> written_parents(clang::ASTContext& ast, const clang::DynTypedNode& node) {
  std::vector<clang::DynTypedNode> written;
  const auto parents = ast.getParents(node);
  std::copy_if(parents.begin(), parents.end(), std::back_inserter(written), [&](const auto& around) {
    return is_written_place(around) && (parents.size() == 1 || holds(around, node));
  });
  if (written.empty() && !parents.empty()) written.push_back(parents[0]);
  return written;
}

Ancestors::Iterator& Ancestors::Iterator::operator++() {
  const auto parent = written_parent(*ast_, node_);
  at_end_ = !parent;
  if (parent) node_ = *parent;
  return *this;
}

bool is_statement(clang::ASTContext& ast, const clang::Expr& expr) {
  auto around = written_parent(ast, clang::DynTypedNode::create(expr));
  if (around && around->get<clang::ExprWithCleanups>()) around = written_parent(ast, *around);
  return around && around->get<clang::Stmt>() && !around->get<clang::Expr>() &&
         !around->get<clang::ReturnStmt>() && !around->get<clang::DeclStmt>();
}

bool is_wrapping(const clang::Stmt* around) {
  return llvm::isa_and_nonnull<clang::ImplicitCastExpr, clang::MaterializeTemporaryExpr, clang::ParenExpr,
                               clang::CXXBindTemporaryExpr, clang::FullExpr>(around);
}

bool is_assigned(const clang::Stmt* around, const clang::Stmt* object) {
  const auto* op = llvm::dyn_cast_or_null<clang::BinaryOperator>(around);
  const auto* call = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(around);
  const auto* step = llvm::dyn_cast_or_null<clang::UnaryOperator>(around);
  return (op && op->isAssignmentOp() && op->getLHS() == object) ||
         (call && call->isAssignmentOp() && call->getArg(0) == object) ||
         (step && step->isIncrementDecrementOp());
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

bool is_instance(const clang::FunctionDecl* function) {
  for (const clang::DeclContext* at = function; at; at = at->getParent()) {
    const auto* around = llvm::dyn_cast<clang::FunctionDecl>(at);
    if ((around && around->isTemplateInstantiation()) ||
        llvm::isa<clang::ClassTemplateSpecializationDecl>(at))
      return true;
  }
  return false;
}

namespace {

/// Whether a lambda's body may name members of the object around it.
bool may_use_this(const clang::CXXRecordDecl* lambda) {
  return lambda->getLambdaCaptureDefault() != clang::LCD_None ||
         llvm::any_of(lambda->captures(),
                      [](const clang::LambdaCapture& capture) { return capture.capturesThis(); });
}

}  // namespace

std::string record_usr_of(const clang::FunctionDecl* function) {
  const clang::DeclContext* context = function;
  while (context && !context->isTranslationUnit()) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(context);
    if (method && !method->getParent()->isLambda())
      return method->isStatic() ? "" : usr_of(method->getParent());
    if (method && !may_use_this(method->getParent())) return "";
    context = context->getParent();
  }
  return "";
}

std::string namespaces_around(const clang::Decl* decl) {
  std::string names;
  for (const clang::DeclContext* context = decl->getDeclContext(); context; context = context->getParent()) {
    const auto* space = llvm::dyn_cast<clang::NamespaceDecl>(context);
    if (space && !space->isAnonymousNamespace())
      names = space->getNameAsString() + (names.empty() ? "" : "::" + names);
  }
  return names;
}

const clang::Expr* converted(const clang::Expr* expr) {
  if (const auto* cast = llvm::dyn_cast<clang::CastExpr>(expr)) return cast->getSubExpr();
  if (const auto* full = llvm::dyn_cast<clang::FullExpr>(expr)) return full->getSubExpr();
  if (const auto* made = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr)) return made->getSubExpr();
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(expr)) return bound->getSubExpr();
  return nullptr;
}

bool is_implicit_wrapper(const clang::Stmt* stmt) {
  return llvm::isa<clang::ParenExpr, clang::ImplicitCastExpr, clang::FullExpr,
                   clang::MaterializeTemporaryExpr, clang::CXXBindTemporaryExpr>(stmt);
}

}  // namespace tzc::rewriter
