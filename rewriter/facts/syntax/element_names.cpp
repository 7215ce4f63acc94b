// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/element_names.h"

#include <llvm/ADT/StringExtras.h>

#include "facts/syntax/ast_walk.h"
#include "model/content_flow.h"

namespace tzc::rewriter {
namespace {

/// Without what has a meaning in the name of a part.
std::string escaped(const std::string& text) {
  static const std::string meaningful = "/[]@%?";
  std::string result;
  for (const char c : text)
    if (meaningful.find(c) != std::string::npos)
      result += "%" + std::to_string(static_cast<unsigned>(c));
    else
      result += c;
  return result;
}

/// for (...; ...; ++i)
bool is_loop_step(const FunctionView& view, const clang::Stmt* stmt) {
  const auto* loop = llvm::dyn_cast_or_null<clang::ForStmt>(view.parent(stmt));
  return loop && loop->getInc() == stmt;
}

bool steps_loop(const FunctionView& view, const clang::DeclRefExpr* use) {
  const auto* step = llvm::dyn_cast_or_null<clang::UnaryOperator>(view.parent(use));
  return step && step->isIncrementDecrementOp() && is_loop_step(view, step);
}

/// A variable of the function that keeps its value until it comes into being again, or its loop goes on.
bool is_steady(const FunctionView& view, const clang::VarDecl* variable) {
  return variable->hasLocalStorage() && !variable->getType()->isReferenceType() &&
         !variable->getType().isVolatileQualified() &&
         llvm::all_of(view.uses(variable), [&](const clang::DeclRefExpr* use) {
           return is_read(view, use) || steps_loop(view, use);
         });
}

class IndexReader {
 public:
  IndexReader(const Unit& unit, const FunctionView& view) : unit_(unit), view_(view) {}

  /// Whether the expression's value depends on steady variables alone.
  bool read(const clang::Expr* expr) {
    expr = expr->IgnoreParenImpCasts();
    if (llvm::isa<clang::IntegerLiteral, clang::CharacterLiteral, clang::StringLiteral,
                  clang::CXXBoolLiteralExpr>(expr))
      return true;
    if (const clang::ValueDecl* lasting = lasting_index(expr)) return depends_on(lasting);
    if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return variable(name->getDecl());
    if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr))
      return op->isArithmeticOp() && read(op->getSubExpr());
    if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(expr))
      return !op->isAssignmentOp() && !op->isPtrMemOp() && read(op->getLHS()) && read(op->getRHS());
    if (const clang::Expr* operand = converted(expr)) return read(operand);
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);  // a std::string of a literal
    return made && made->getNumArgs() > 0 &&
           llvm::all_of(made->arguments(), [&](const clang::Expr* argument) {
             return llvm::isa<clang::CXXDefaultArgExpr>(argument) || read(argument);
           });
  }

  const std::string& tokens() const { return tokens_; }

 private:
  bool variable(const clang::ValueDecl* decl) {
    if (llvm::isa<clang::EnumConstantDecl>(decl)) return true;
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
    return variable && is_steady(view_, variable) && depends_on(variable);
  }

  bool depends_on(const clang::ValueDecl* variable) {
    tokens_ += index_token(unit_, variable);
    return true;
  }

  const Unit& unit_;
  const FunctionView& view_;
  std::string tokens_;
};

}  // namespace

std::string element_name(const Unit& unit, const FunctionView& view, const clang::Expr* index) {
  if (index->getBeginLoc().isMacroID()) return any_element();
  clang::Expr::EvalResult value;
  if (!index->isValueDependent() && index->EvaluateAsInt(value, unit.ast()))
    return llvm::toString(value.Val.getInt(), 10);
  IndexReader reader(unit, view);
  return reader.read(index) ? escaped(unit.text(index)) + reader.tokens() : any_element();
}

std::string index_token(const Unit& unit, const clang::ValueDecl* variable) {
  const auto* local = llvm::dyn_cast<clang::VarDecl>(variable);
  const bool lasts = !local || local->hasGlobalStorage();
  return "@" + (lasts ? "!" + usr_of(variable) : std::to_string(unit.offset(variable->getLocation()))) + "@";
}

bool is_read(const FunctionView& view, const clang::Expr* mention) {
  if (mention->getType().isConstQualified()) return true;
  const clang::Stmt* around = view.parent(mention);
  while (llvm::isa_and_nonnull<clang::ParenExpr>(around)) around = view.parent(around);
  const auto* cast = llvm::dyn_cast_or_null<clang::ImplicitCastExpr>(around);
  return cast && (cast->getCastKind() == clang::CK_LValueToRValue || cast->getType().isConstQualified());
}

const clang::ValueDecl* lasting_index(const clang::Expr* expr) {
  const clang::ValueDecl* decl = nullptr;
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) {
    if (llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts()))
      decl = member->getMemberDecl();
  } else if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(name->getDecl());
    if (variable && variable->hasGlobalStorage()) decl = variable;
  }
  const bool is_number =
      decl && decl->getType()->isIntegralOrEnumerationType() && !decl->getType().isVolatileQualified();
  return is_number ? decl : nullptr;
}

bool is_index(const FunctionView& view, const clang::VarDecl* variable) {
  return variable->isCXXForRangeDecl() ||
         llvm::any_of(view.uses(variable), [&](const clang::DeclRefExpr* use) {
           const clang::Stmt* around = view.parent(use);
           while (around && (is_implicit_wrapper(around) ||
                             llvm::isa<clang::CastExpr, clang::UnaryOperator, clang::BinaryOperator,
                                       clang::CXXConstructExpr>(around)))
             around = view.parent(around);
           return llvm::isa_and_nonnull<clang::ArraySubscriptExpr, clang::CallExpr>(around);
         });
}

}  // namespace tzc::rewriter
