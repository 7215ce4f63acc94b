// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/lock_guarded.h"

#include "facts/sites/unshared_object.h"
#include "facts/syntax/ast_walk.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// Nobody but the code of this unit can name it.
bool is_of_this_unit(const Unit& unit, const clang::ValueDecl* named) {
  const clang::SourceManager& manager = unit.ast().getSourceManager();
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(named);
  if (!field) return !named->isExternallyVisible();
  if (manager.isWrittenInMainFile(manager.getExpansionLoc(field->getLocation()))) return true;
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent());
  return record && field->getAccess() == clang::AS_private && is_seen_whole(record);
}

/// pub_.publish(...), pub_->getTopic(), a copy, a const reference
bool only_asks(clang::ASTContext& ast, const clang::Expr* mention) {
  if (mention->getType().isConstQualified()) return true;
  for (const clang::DynTypedNode& node : ancestors(ast, *mention)) {
    const auto* cast = node.get<clang::ImplicitCastExpr>();
    if (cast && (!cast->isGLValue() || cast->getType().isConstQualified())) return true;
    if (const auto* call = node.get<clang::CallExpr>()) {
      const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(call->getDirectCallee());
      return method && method->isConst();
    }
    const auto* member = node.get<clang::MemberExpr>();
    if (!node.get<clang::ImplicitCastExpr>() && !node.get<clang::ParenExpr>() &&
        !(member && llvm::isa<clang::CXXMethodDecl>(member->getMemberDecl())))
      return false;
  }
  return false;
}

class LaterChanges : public AstVisitor {
 public:
  LaterChanges(const Unit& unit, const clang::ValueDecl* named) : unit_(unit), named_(named) {}
  bool found = false;

  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    return look_at(reference, reference->getDecl());
  }
  bool VisitMemberExpr(clang::MemberExpr* member) override {
    return look_at(member, member->getMemberDecl());
  }
  bool shouldVisitTemplateInstantiations() const override { return true; }

 private:
  bool look_at(const clang::Expr* mention, const clang::ValueDecl* what) {
    const bool is_it = what->getCanonicalDecl() == named_->getCanonicalDecl();
    found = found || (is_it && changes_what_others_see(unit_, mention, what));
    return !found;
  }
  const Unit& unit_;
  const clang::ValueDecl* named_;
};

bool is_own_variable(const clang::ValueDecl* named) {
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(named);
  return variable && variable->hasLocalStorage();
}

}  // namespace

bool changes_what_others_see(const Unit& unit, const clang::Expr* mention, const clang::ValueDecl* named) {
  if (is_own_variable(named) && !named->getType()->isReferenceType()) return false;
  return !only_asks(unit.ast(), mention) && !is_made_here(unit, mention, named);
}

bool may_be_lock_guarded(const Unit& unit, const clang::ValueDecl* named) {
  if (named->getType().isConstQualified() || is_own_variable(named)) return false;
  if (!is_of_this_unit(unit, named)) return true;
  LaterChanges changes(unit, named);
  changes.TraverseAST(unit.ast());
  return changes.found;
}

}  // namespace tzc::rewriter
