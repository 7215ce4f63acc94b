// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/unshared_object.h"

#include <set>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "facts/syntax/lock_names.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {

namespace {

/// Whether another thread may wait for something that the function does: it, or a function of the package that it calls, takes a lock,
/// or it calls what is not known.
class Awaited : public AstVisitor {
 public:
  explicit Awaited(const Unit& unit) : unit_(unit) {}

  bool is(const clang::FunctionDecl* function) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
    function = shown_body(function);
    if (!function || (method && method->isVirtual())) return true;
    if (seen_.insert(function).second && !found_) TraverseStmt(function->getBody());
    return found_;
  }

 private:
  bool VisitStmt(clang::Stmt* stmt) override {
    found_ = found_ || takes_lock(stmt);
    return !found_;
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    found_ = found_ || !callee || may_take_lock(callee);
    return !found_;
  }
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* made) override {
    found_ = found_ || may_take_lock(made->getConstructor());
    return !found_;
  }
  bool may_take_lock(const clang::FunctionDecl* function) {
    return !function->isImplicit() && !function->isDefaulted() &&
           unit_.source.in_package(function->getLocation()) && is(function);
  }

  const Unit& unit_;
  std::set<const clang::FunctionDecl*> seen_;
  bool found_ = false;
};

const clang::Expr* whole_expression(clang::ASTContext& ast, const clang::Expr* part) {
  for (const clang::DynTypedNode& node : ancestors(ast, *part)) {
    const auto* around = node.get<clang::Expr>();
    if (!around) break;
    part = around;
  }
  return part;
}

bool may_run_again(clang::ASTContext& ast, const clang::Expr* expr) {
  for (const clang::DynTypedNode& node : ancestors(ast, *expr)) {
    if (node.get<clang::FunctionDecl>()) return false;
    if (node.get<clang::ForStmt>() || node.get<clang::WhileStmt>() || node.get<clang::DoStmt>() ||
        node.get<clang::CXXForRangeStmt>() || node.get<clang::LabelStmt>())
      return true;
  }
  return true;
}

/// Whether code that stands before the end of an expression in its function may have given others something to run.
class StartedBefore : public AstVisitor {
 public:
  StartedBefore(const Unit& unit, const clang::Expr* expr)
      : unit_(unit),
        end_(may_run_again(unit.ast(), expr) ? clang::SourceLocation()
                                             : whole_expression(unit.ast(), expr)->getEndLoc()) {}

  bool in(const clang::FunctionDecl* function) {
    const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(function);
    if (constructor)
      for (const clang::CXXCtorInitializer* first : constructor->inits()) TraverseStmt(first->getInit());
    TraverseStmt(function->getBody());
    return found_;
  }

 private:
  bool VisitStmt(clang::Stmt* stmt) override {
    const clang::SourceManager& manager = unit_.ast().getSourceManager();
    const bool is_later =
        end_.isValid() && manager.isBeforeInTranslationUnit(manager.getExpansionLoc(end_),
                                                            manager.getExpansionLoc(stmt->getBeginLoc()));
    found_ = found_ || (!is_later && (may_synchronize(stmt) || gives_away(stmt)));
    return !found_;
  }
  /// Names a function of the package, makes an object of one of its classes, or has a closure, or a pointer to this object.
  bool gives_away(const clang::Stmt* stmt) const {
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt);
    const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt);
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt);
    const auto* self = llvm::dyn_cast<clang::CXXThisExpr>(stmt);
    const clang::Decl* named = nullptr;
    if (made) named = made->getConstructor();
    if (reference) named = reference->getDecl();
    if (member) named = member->getMemberDecl();
    return (named && llvm::isa<clang::FunctionDecl>(named) &&
            unit_.source.in_package(named->getLocation())) ||
           llvm::isa<clang::LambdaExpr>(stmt) || (self && !self->isImplicit());
  }

  const Unit& unit_;
  clang::SourceLocation end_;  ///< invalid: all of the function
  bool found_ = false;
};

/// Whether others cannot know yet of what the function makes: nothing that runs before has told them of it, or they need not wait for
/// what comes later.
bool is_unknown_to_others(const Unit& unit, const clang::FunctionDecl* function, const clang::Expr* at) {
  return !StartedBefore(unit, at).in(function) || !Awaited(unit).is(function);
}

/// Whether nothing names a private member function but constructors of its class, which call it for the object that they make.
class ConstructorsOnly : public AstVisitor {
 public:
  ConstructorsOnly(const Unit& unit, const clang::CXXMethodDecl* method) : unit_(unit), method_(method) {}

  bool hold() {
    const clang::CXXRecordDecl* record = method_->getParent();
    if (method_->getAccess() != clang::AS_private || method_->isVirtual() || record->isDependentContext())
      return false;
    look_into(record);
    return !found_other_;
  }

 private:
  /// All code that may name what is private in the class.
  void look_into(const clang::CXXRecordDecl* record) {
    found_other_ = found_other_ || !is_seen_whole(record);
    for (clang::Decl* decl : record->decls()) {
      const auto* nested = llvm::dyn_cast<clang::CXXRecordDecl>(decl);
      auto* function = llvm::dyn_cast<clang::FunctionDecl>(decl);
      if (llvm::isa<clang::TemplateDecl>(decl)) found_other_ = true;
      if (nested && !nested->isImplicit() && nested->isThisDeclarationADefinition()) look_into(nested);
      if (!nested) TraverseDecl(function && function->isDefined() ? function->getDefinition() : decl);
    }
  }

  bool VisitStmt(clang::Stmt* stmt) override {
    found_other_ = found_other_ || (names_it(stmt) && !calls_it_while_making(stmt));
    return !found_other_;
  }
  bool names_it(const clang::Stmt* stmt) const {
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt))
      return member->getMemberDecl()->getCanonicalDecl() == method_->getCanonicalDecl();
    if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
      return reference->getDecl()->getCanonicalDecl() == method_->getCanonicalDecl();
    if (const auto* names = llvm::dyn_cast<clang::OverloadExpr>(stmt))
      return names->getName() == method_->getDeclName();
    const auto* dependent = llvm::dyn_cast<clang::CXXDependentScopeMemberExpr>(stmt);
    return dependent && dependent->getMember() == method_->getDeclName();
  }
  bool calls_it_while_making(const clang::Stmt* name) const {
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(name);
    const clang::FunctionDecl* caller = enclosing_function(unit_.ast(), *name);
    return member && llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts()) &&
           llvm::isa_and_nonnull<clang::CXXConstructorDecl>(caller) &&
           llvm::cast<clang::CXXConstructorDecl>(caller)->getParent()->getCanonicalDecl() ==
               method_->getParent()->getCanonicalDecl() &&
           is_unknown_to_others(unit_, caller, member);
  }

  const Unit& unit_;
  const clang::CXXMethodDecl* method_;
  bool found_other_ = false;
};

}  // namespace

bool is_seen_whole(const clang::CXXRecordDecl* record) {
  return !record->hasFriends() && llvm::all_of(record->methods(), [](const clang::CXXMethodDecl* method) {
    return method->isImplicit() || method->isDefaulted() || method->isDeleted() ||
           (method->isDefined() && !may_have_another_body(method));
  });
}

bool is_made_here(const Unit& unit, const clang::Expr* mention, const clang::ValueDecl* named) {
  const clang::FunctionDecl* function = enclosing_function(unit.ast(), *mention);
  if (!function) return false;
  if (function->isMain()) return !takes_locks(function) && is_unknown_to_others(unit, function, mention);
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return method && method->getParent()->getCanonicalDecl() == named->getDeclContext()->getPrimaryContext() &&
         (llvm::isa<clang::CXXConstructorDecl>(method) || ConstructorsOnly(unit, method).hold()) &&
         is_unknown_to_others(unit, function, mention);
}

}  // namespace tzc::rewriter
