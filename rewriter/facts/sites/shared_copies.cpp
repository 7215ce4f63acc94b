// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/shared_copies.h"

#include <clang/AST/ExprCXX.h>

#include <algorithm>

#include "facts/flow/message_copies.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

bool names(const clang::Expr* expr, const clang::VarDecl* variable) {
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
  return name && name->getDecl() == variable;
}

class NameFinder : public AstVisitor {
 public:
  explicit NameFinder(const clang::VarDecl* variable) : variable_(variable) {}
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    found = found || reference->getDecl() == variable_;
    return !found;
  }
  bool found = false;

 private:
  const clang::VarDecl* const variable_;
};

bool mentions(const clang::Stmt* part, const clang::VarDecl* variable) {
  NameFinder finder(variable);
  if (part) finder.TraverseStmt(const_cast<clang::Stmt*>(part));
  return finder.found;
}

/// What may use a message by another name: its address, a reference to it or a part of it, a closure.
class OtherName : public AstVisitor {
 public:
  explicit OtherName(const clang::VarDecl* message) : message_(message) {}
  bool VisitUnaryOperator(clang::UnaryOperator* op) override {
    found = found || (op->getOpcode() == clang::UO_AddrOf && mentions(op->getSubExpr(), message_));
    return !found;
  }
  bool VisitVarDecl(clang::VarDecl* variable) override {
    found = found || (variable->getType()->isReferenceType() && mentions(variable->getInit(), message_));
    return !found;
  }
  bool VisitLambdaExpr(clang::LambdaExpr* lambda) override {
    found = found || llvm::any_of(lambda->captures(), [&](const clang::LambdaCapture& capture) {
              return capture.capturesVariable() && capture.getCapturedVar() == message_;
            });
    return !found;
  }
  bool found = false;

 private:
  const clang::VarDecl* const message_;
};

bool is_statement_that_publishes(const clang::Stmt* statement, const clang::VarDecl* message) {
  const auto* expr = llvm::dyn_cast<clang::Expr>(statement);
  const auto* call = expr ? llvm::dyn_cast<clang::CallExpr>(expr->IgnoreImplicit()) : nullptr;
  return call && llvm::any_of(published_by(call),
                              [&](const clang::Expr* argument) { return names(argument, message); });
}

/// A block may be entered there.
bool is_target(const clang::Stmt* statement) {
  return llvm::isa<clang::LabelStmt, clang::SwitchCase>(statement);
}

/// The local message that the variable is a copy of; null: it is none.
const clang::VarDecl* original_of(const clang::VarDecl* copy) {
  const clang::Expr* source = copy->getInit() ? copied_by(copy->getInit()) : nullptr;
  const auto* name = source ? llvm::dyn_cast<clang::DeclRefExpr>(source->IgnoreParenImpCasts()) : nullptr;
  const auto* original = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  const bool is_own = original && original->hasLocalStorage() && !llvm::isa<clang::ParmVarDecl>(original);
  return is_own && message_of(original->getType()) ? original : nullptr;
}

enum class Before { published, named, neither };

/// What the statements of a block do with a message in front of one of them, the last of those that name it.
Before in_front_of(const clang::Stmt* statement, const clang::CompoundStmt* block,
                   const clang::VarDecl* message) {
  if (is_target(statement)) return Before::named;
  const auto end = std::find(block->body_begin(), block->body_end(), statement);
  for (auto at = std::make_reverse_iterator(end); at != std::make_reverse_iterator(block->body_begin());
       ++at) {
    if (is_statement_that_publishes(*at, message)) return Before::published;
    if (is_target(*at) || mentions(*at, message)) return Before::named;
  }
  return Before::neither;
}

/// The statement around a block that leads to it once, without the message's name; null: it is another one.
const clang::Stmt* leading_to(const Unit& unit, const clang::CompoundStmt* block,
                              const clang::VarDecl* message) {
  const auto* around = parent_as<clang::Stmt>(unit.ast(), *block);
  if (llvm::isa_and_nonnull<clang::CompoundStmt>(around)) return block;
  const auto* branch = llvm::dyn_cast_or_null<clang::IfStmt>(around);
  const bool is_free = branch && !mentions(branch->getInit(), message) &&
                       !mentions(branch->getConditionVariableDeclStmt(), message) &&
                       !mentions(branch->getCond(), message);
  return is_free ? branch : nullptr;
}

}  // namespace

bool shares_published(const Unit& unit, const clang::VarDecl* copy) {
  const clang::VarDecl* original = copy->getType().isConstQualified() ? original_of(copy) : nullptr;
  const clang::Stmt* at = original ? parent_as<clang::DeclStmt>(unit.ast(), *copy) : nullptr;
  const clang::FunctionDecl* function = at ? enclosing_function(unit.ast(), *at) : nullptr;
  if (!function || !function->getBody()) return false;
  OtherName other(original);
  other.TraverseStmt(function->getBody());
  if (other.found) return false;
  while (at) {
    const auto* block = parent_as<clang::CompoundStmt>(unit.ast(), *at);
    if (!block) return false;
    const Before before = in_front_of(at, block, original);
    if (before != Before::neither) return before == Before::published;
    at = leading_to(unit, block, original);
  }
  return false;
}

}  // namespace tzc::rewriter
