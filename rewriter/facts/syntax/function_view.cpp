// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/function_view.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/StmtCXX.h>

namespace tzc::rewriter {
namespace {

/// Where the repeated part of a loop begins; null: the statement is no loop.
const clang::Stmt* first_repeated(const clang::Stmt* stmt) {
  if (const auto* loop = llvm::dyn_cast<clang::ForStmt>(stmt)) {
    if (loop->getConditionVariableDeclStmt()) return loop->getConditionVariableDeclStmt();
    if (loop->getCond()) return loop->getCond();
    return loop->getInc() ? loop->getInc() : loop->getBody();
  }
  if (const auto* loop = llvm::dyn_cast<clang::CXXForRangeStmt>(stmt)) return loop->getCond();
  return llvm::isa<clang::WhileStmt, clang::DoStmt>(stmt) ? stmt : nullptr;
}

}  // namespace

FunctionView::FunctionView(const clang::FunctionDecl* definition) : function_(definition) {
  if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(definition))
    for (const clang::CXXCtorInitializer* initializer : constructor->inits()) {
      initializers_[initializer->getInit()] = initializer;
      walk(initializer->getInit(), nullptr, nullptr);
    }
  walk(definition->getBody(), nullptr, nullptr);
  for (const clang::Stmt* stmt : statements_) note_loop(stmt);
}

void FunctionView::walk(const clang::Stmt* stmt, const clang::Stmt* parent, const clang::LambdaExpr* lambda) {
  if (!stmt) return;
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(stmt); list && list->getSemanticForm())
    stmt = list->getSemanticForm();
  if (!nodes_.emplace(stmt, Node{parent, lambda, {clock_++, 0}}).second) return;
  statements_.push_back(stmt);
  note(stmt);
  const auto* closure = llvm::dyn_cast<clang::LambdaExpr>(stmt);
  if (const auto* in_class = llvm::dyn_cast<clang::CXXDefaultInitExpr>(stmt))
    walk(in_class->getExpr(), stmt, lambda);
  if (const auto* region = llvm::dyn_cast<clang::CapturedStmt>(stmt))
    walk(region->getCapturedStmt(), stmt, lambda);
  for (const clang::Stmt* child : stmt->children())
    walk(child, stmt, closure && child == closure->getBody() ? closure : lambda);
  nodes_[stmt].span.exit = clock_++;
}

void FunctionView::note(const clang::Stmt* stmt) {
  jumps_ |= llvm::isa<clang::GotoStmt, clang::IndirectGotoStmt, clang::LabelStmt, clang::CapturedStmt>(stmt);
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
    uses_[reference->getDecl()].push_back(reference);
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt))
    for (const clang::Decl* decl : declaration->decls())
      if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl)) declarations_[variable] = declaration;
}

void FunctionView::note_loop(const clang::Stmt* stmt) {
  if (const clang::Stmt* first = first_repeated(stmt))
    repeated_.push_back({span(first).enter, span(stmt).exit});
}

const clang::Stmt* FunctionView::parent(const clang::Stmt* stmt) const {
  const auto found = nodes_.find(stmt);
  return found == nodes_.end() ? nullptr : found->second.parent;
}

FunctionView::Span FunctionView::span(const clang::Stmt* stmt) const {
  const auto found = nodes_.find(stmt);
  return found == nodes_.end() ? Span() : found->second.span;
}

const clang::Stmt* FunctionView::full_expression(const clang::Stmt* stmt) const {
  for (const clang::Stmt* around = parent(stmt); llvm::isa_and_nonnull<clang::Expr>(around);
       around = parent(around))
    stmt = around;
  return stmt;
}

const clang::LambdaExpr* FunctionView::lambda_around(const clang::Stmt* stmt) const {
  const auto found = nodes_.find(stmt);
  return found == nodes_.end() ? nullptr : found->second.lambda;
}

bool FunctionView::runs_within(const clang::LambdaExpr* inner, const clang::LambdaExpr* outer) const {
  for (; inner && inner != outer; inner = lambda_around(inner)) {
  }
  return inner == outer;
}

const clang::CXXCtorInitializer* FunctionView::initializer(const clang::Stmt* stmt) const {
  const auto found = initializers_.find(stmt);
  return found == initializers_.end() ? nullptr : found->second;
}

const clang::DeclStmt* FunctionView::declaration(const clang::VarDecl* variable) const {
  const auto found = declarations_.find(variable);
  return found == declarations_.end() ? nullptr : found->second;
}

const std::vector<const clang::DeclRefExpr*>& FunctionView::uses(const clang::ValueDecl* decl) const {
  static const std::vector<const clang::DeclRefExpr*> none;
  const auto found = uses_.find(decl);
  return found == uses_.end() ? none : found->second;
}

}  // namespace tzc::rewriter
