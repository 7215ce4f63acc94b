// SPDX-License-Identifier: BSD-3-Clause
#include "facts/lock_guarded.h"

#include "facts/ast_walk.h"
#include "facts/must_execute.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

bool is_seen_whole(const clang::CXXRecordDecl* record) {
  return !record->hasFriends() && llvm::all_of(record->methods(), [](const clang::CXXMethodDecl* method) {
    return method->isImplicit() || method->isDefaulted() || method->isDeleted() || method->isDefined();
  });
}

/// Nobody but the code of this unit can name it.
bool is_of_this_unit(const Unit& unit, const clang::ValueDecl* named) {
  const clang::SourceManager& manager = unit.ast().getSourceManager();
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(named);
  if (!field) return !named->isExternallyVisible();
  if (manager.isWrittenInMainFile(manager.getExpansionLoc(field->getLocation()))) return true;
  const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(field->getParent());
  return record && field->getAccess() == clang::AS_private && is_seen_whole(record);
}

/// pub_.publish(...), pub_->getTopic()
bool only_asks(clang::ASTContext& ast, const clang::Expr* mention) {
  for (const clang::DynTypedNode& node : ancestors(ast, *mention)) {
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

bool locks_before(const Unit& unit, const clang::FunctionDecl* function, unsigned offset) {
  const NameParts nothing;
  return MustExecute(unit, nothing, function->getBody()).locks_between(0, offset);
}

class Changes : public AstVisitor {
 public:
  Changes(const Unit& unit, const clang::ValueDecl* named) : unit_(unit), named_(named) {}
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
    found = found || (is_it && !only_asks(unit_.ast(), mention) && !is_made_here(mention));
    return !found;
  }
  /// Nobody else has the object yet.
  bool is_made_here(const clang::Expr* mention) const {
    const clang::FunctionDecl* function = enclosing_function(unit_.ast(), *mention);
    if (!function) return false;
    const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(function);
    return (constructor &&
            constructor->getParent()->getCanonicalDecl() == named_->getDeclContext()->getPrimaryContext()) ||
           (function->isMain() && !locks_before(unit_, function, ~0U));
  }

  const Unit& unit_;
  const clang::ValueDecl* named_;
};

}  // namespace

bool may_be_lock_guarded(const Unit& unit, const clang::ValueDecl* named) {
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(named);
  if (named->getType().isConstQualified() || (variable && variable->hasLocalStorage())) return false;
  if (!is_of_this_unit(unit, named)) return true;
  Changes changes(unit, named);
  changes.TraverseAST(unit.ast());
  return changes.found;
}

bool stands_under_lock(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = enclosing_function(unit.ast(), *call);
  return function && function->getBody() && !llvm::isa<clang::CXXConstructorDecl>(function) &&
         locks_before(unit, function, unit.offset(call->getExprLoc()));
}

}  // namespace tzc::rewriter
