// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/later_writes.h"

#include <clang/AST/ExprCXX.h>

#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// A variable is assigned, swapped, or something else may write to it.
class LaterWrites : public AstVisitor {
 public:
  explicit LaterWrites(const clang::VarDecl* variable) : variable_(variable) {}
  bool found = false;

  bool VisitBinaryOperator(clang::BinaryOperator* op) override {
    return note(op->isAssignmentOp() && is_named(op->getLHS()));
  }
  bool VisitCXXOperatorCallExpr(clang::CXXOperatorCallExpr* op) override {
    return note(op->isAssignmentOp() && is_named(op->getArg(0)));
  }
  bool VisitUnaryOperator(clang::UnaryOperator* op) override {
    return note(op->getOpcode() == clang::UO_AddrOf && is_named(op->getSubExpr()));
  }
  bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* call) override {
    const clang::CXXMethodDecl* method = call->getMethodDecl();
    return note(method && !method->isConst() && is_named(call->getImplicitObjectArgument()));
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    if (llvm::isa<clang::CXXOperatorCallExpr>(call)) return !found;  // see above
    const clang::FunctionDecl* function = call->getDirectCallee();
    for (unsigned i = 0; function && i < call->getNumArgs() && i < function->getNumParams(); ++i) {
      const auto* reference = function->getParamDecl(i)->getType()->getAs<clang::LValueReferenceType>();
      // One that is written as T&& passes it on.
      if (reference && reference->isSpelledAsLValue() && !reference->getPointeeType().isConstQualified())
        note(is_named(call->getArg(i)));
    }
    return !found;
  }

 private:
  bool is_named(const clang::Expr* expr) const {
    const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
    return name && name->getDecl() == variable_;
  }
  bool note(bool writes) {
    found |= writes;
    return !found;
  }
  const clang::VarDecl* variable_;
};

}  // namespace

bool may_change_later(const clang::VarDecl* variable) {
  if (variable->getType().isConstQualified()) return false;
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(variable->getDeclContext());
  if (!function || !function->getBody() || variable->isStaticLocal()) return true;
  LaterWrites writes(variable);
  writes.TraverseStmt(function->getBody());
  return writes.found;
}

}  // namespace tzc::rewriter
