// SPDX-License-Identifier: BSD-3-Clause
#include "facts/stock_copies.h"

#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/AST/StmtCXX.h>

#include "facts/ast_walk.h"
#include "facts/message_type.h"

namespace tzc::rewriter {
namespace {

const char* const kRule = "stock-copy";

/// A name that an implicit cast may stand around, as written; null: it is no variable's name.
const clang::DeclRefExpr* name_in(const clang::Expr* expr) {
  return llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreImpCasts());
}

bool refers_to_const(clang::QualType type) {
  return type->isLValueReferenceType() && type->getPointeeType().isConstQualified();
}

/// By value, or as const: what it is given it cannot write to. A value may be a pointer.
bool only_reads(const clang::ParmVarDecl* parameter) {
  const clang::QualType type = parameter->getType();
  if (type->isReferenceType()) return refers_to_const(type);
  return type->isArithmeticType() || type->isEnumeralType();
}

/// Whether a function that writes to the message can keep where it is only in a global.
bool keeps_nothing(const clang::FunctionDecl* function, unsigned message) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method && method->isInstance()) return false;
  const clang::QualType result = function->getReturnType();
  if (!result->isVoidType() && !result->isArithmeticType() && !result->isEnumeralType()) return false;
  for (unsigned i = 0; i < function->getNumParams(); ++i)
    if (i != message && !only_reads(function->getParamDecl(i))) return false;
  return !function->isVariadic();
}

enum class Mention { number, look, write, other };

/// All that happens to a variable in its function.
class Mentions : public clang::RecursiveASTVisitor<Mentions> {
 public:
  Mentions(const Unit& unit, const clang::VarDecl* variable) : unit_(unit), variable_(variable) {}

  bool VisitDeclRefExpr(const clang::DeclRefExpr* name) {
    if (name->getDecl() != variable_) return true;
    const Mention kind = kind_of(name);
    followable_ = followable_ && kind != Mention::other;
    if (kind == Mention::look) ++looks_;
    if (kind == Mention::write) last_write_ = std::max(last_write_, unit_.offset(name->getLocation()));
    return true;
  }
  bool VisitLambdaExpr(const clang::LambdaExpr* lambda) {
    for (const clang::LambdaCapture& capture : lambda->captures())
      if (!capture.capturesVariable() || capture.getCapturedVar() == variable_) followable_ = false;
    return true;
  }
  bool VisitLabelStmt(const clang::LabelStmt*) { return followable_ = false; }
  bool VisitAsmStmt(const clang::AsmStmt*) { return followable_ = false; }

  bool are_followable() const { return followable_; }
  /// One call alone is given it to look at, in this expression; nobody writes to it there, nor behind that.
  bool are_over_at(const clang::Expr* expr) const {
    while (const clang::Expr* around = around_of(expr)) expr = around;
    return looks_ == 1 && last_write_ < unit_.offset(expr->getBeginLoc());
  }

 private:
  Mention kind_of(const clang::DeclRefExpr* name) const {
    const clang::Expr* at = name;
    while (const auto* around = around_of(at)) {
      if (const auto* call = llvm::dyn_cast<clang::CallExpr>(around)) return as_argument(call, at);
      const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(around);
      if (cast && cast->getCastKind() == clang::CK_LValueToRValue)
        return cast->getType()->isArithmeticType() ? Mention::number : Mention::other;
      const auto* member = llvm::dyn_cast<clang::MemberExpr>(around);
      if (!cast && !(member && llvm::isa<clang::FieldDecl>(member->getMemberDecl()))) return Mention::other;
      at = around;
    }
    return Mention::other;
  }

  const clang::Expr* around_of(const clang::Expr* expr) const {
    const auto parent = written_parent(unit_.ast(), clang::DynTypedNode::create(*expr));
    return parent ? parent->get<clang::Expr>() : nullptr;
  }

  /// The message itself, not a part of it.
  Mention as_argument(const clang::CallExpr* call, const clang::Expr* given) const {
    const clang::FunctionDecl* function = call->getDirectCallee();
    if (!function || !name_in(given) || llvm::isa<clang::CXXOperatorCallExpr>(call)) return Mention::other;
    for (unsigned i = 0; i < call->getNumArgs() && i < function->getNumParams(); ++i) {
      if (call->getArg(i) != given) continue;
      if (refers_to_const(function->getParamDecl(i)->getType())) return Mention::look;
      return keeps_nothing(function, i) ? Mention::write : Mention::other;
    }
    return Mention::other;
  }

  const Unit& unit_;
  const clang::VarDecl* variable_;
  bool followable_ = true;
  unsigned last_write_ = 0;
  unsigned looks_ = 0;
};

/// The block in which the variable is declared alone, by a declaration that is a statement of it; null: there is none.
const clang::CompoundStmt* block_of(const Unit& unit, const clang::DeclStmt* declaration) {
  return declaration && declaration->isSingleDecl() ? parent_as<clang::CompoundStmt>(unit.ast(), *declaration)
                                                    : nullptr;
}

/// Whether the statement runs at most once each time that the block runs.
bool runs_once_in(const Unit& unit, const clang::CompoundStmt* block, const clang::Stmt* statement) {
  for (const clang::DynTypedNode& around : ancestors(unit.ast(), *statement)) {
    const auto* stmt = around.get<clang::Stmt>();
    if (stmt == block) return true;
    if (llvm::isa_and_nonnull<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt,
                              clang::LambdaExpr>(stmt))
      return false;
  }
  return false;
}

bool is_taken(const Unit& unit, const std::string& name) {
  return unit.ast().Idents.find(name) != unit.ast().Idents.end();
}

}  // namespace

namespace {

/// A local variable that starts as an empty message, in a function that is written once; null: the name is none of one.
const clang::VarDecl* local_message(const clang::VarDecl* variable) {
  if (!variable || !variable->hasLocalStorage() || llvm::isa<clang::ParmVarDecl>(variable) ||
      !message_of(variable->getType()))
    return nullptr;
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(variable->getDeclContext());
  if (!function || !function->hasBody() || function->isTemplateInstantiation()) return nullptr;
  const auto* made = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(variable->getInit());
  return !variable->getInit() || (made && made->getNumArgs() == 0) ? variable : nullptr;
}

Mentions mentions_of(const Unit& unit, const clang::VarDecl* variable) {
  Mentions mentions(unit, variable);
  mentions.TraverseStmt(llvm::cast<clang::FunctionDecl>(variable->getDeclContext())->getBody());
  return mentions;
}

}  // namespace

std::vector<Change> changes_for_stock_copy(const Unit& unit, const clang::CallExpr* call, unsigned argument) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || llvm::isa<clang::CXXOperatorCallExpr>(call) || argument >= function->getNumParams() ||
      !refers_to_const(function->getParamDecl(argument)->getType()))
    return {};
  const clang::DeclRefExpr* name = name_in(call->getArg(argument));
  const clang::VarDecl* variable =
      local_message(name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr);
  const auto* declaration = variable ? parent_as<clang::DeclStmt>(unit.ast(), *variable) : nullptr;
  const clang::CompoundStmt* block = block_of(unit, declaration);
  if (!block || !runs_once_in(unit, block, call)) return {};
  const Mentions mentions = mentions_of(unit, variable);
  const std::string copy = variable->getNameAsString() + "_stock";
  const auto at = unit.source.place(name->getSourceRange());
  const auto behind = unit.source.behind(declaration->getSourceRange());
  if (!mentions.are_followable() || !mentions.are_over_at(call) || !at || !behind || is_taken(unit, copy))
    return {};
  const std::string type = stock_name(message_of(variable->getType())->name);
  return {{*behind, "\n" + unit.source.indent(*behind) + type + " " + copy + ";", kRule, {}},
          {*at, copy + " = tzc::message::to_stock(" + unit.source.text(*at) + ")", kRule, {}}};
}

}  // namespace tzc::rewriter
