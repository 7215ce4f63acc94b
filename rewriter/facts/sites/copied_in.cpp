// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/copied_in.h"

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/message_parts.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

class Uses : public AstVisitor {
 public:
  explicit Uses(const clang::VarDecl* variable) : variable_(variable) {}
  bool are_copies() const { return pushed_ > 0 && mentions_ == fields_ + pushed_; }

  bool VisitDeclRefExpr(clang::DeclRefExpr* name) override {
    mentions_ += name->getDecl() == variable_;
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) override {
    fields_ += is_it(member->getBase()) && llvm::isa<clang::FieldDecl>(member->getMemberDecl());
    return true;
  }
  bool VisitCXXMemberCallExpr(clang::CXXMemberCallExpr* call) override {
    const auto* array =
        llvm::dyn_cast<clang::MemberExpr>(call->getImplicitObjectArgument()->IgnoreParenImpCasts());
    const clang::CXXMethodDecl* method = call->getMethodDecl();
    pushed_ += array && is_array_of_data_parts(array->getType()) && method &&
               method->getNameAsString() == "push_back" && is_it(call->getArg(0));
    return true;
  }

 private:
  bool is_it(const clang::Expr* expr) const {
    const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
    return name && name->getDecl() == variable_;
  }

  const clang::VarDecl* const variable_;
  unsigned mentions_ = 0, fields_ = 0, pushed_ = 0;
};

}  // namespace

bool is_only_copied_in(const clang::VarDecl* variable) {
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(variable->getDeclContext());
  if (!function || !function->hasBody()) return false;
  Uses uses(variable);
  uses.TraverseStmt(function->getBody());
  return uses.are_copies();
}

}  // namespace tzc::rewriter
