// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/must_execute.h"

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/lock_names.h"
#include "facts/syntax/window_callbacks.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

unsigned begin_of(const Unit& unit, const clang::Stmt* stmt) {
  return unit.offset(stmt->getBeginLoc());
}

/// A mention of a pointer or container that leaves it as it is.
bool only_looks(const Unit& unit, const clang::Expr* mention) {
  if (mention->getType().isConstQualified()) return true;
  const auto* around = parent_as<clang::Expr>(unit.ast(), *mention);
  if (!around) return false;
  if (llvm::isa<clang::ParenExpr>(around)) return only_looks(unit, around);
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(around))
    return !cast->isGLValue() || cast->getType().isConstQualified() || only_looks(unit, cast);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(around)) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
    return !method || method->isConst() || member->isArrow();
  }
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(around);
  return is_step(around) && (!op || !op->isAssignmentOp());
}

/// Whether code of the package that runs unseen could change where the steps of a name lead: it cannot get at a local variable
/// that is only read, or assigned under its own name outside of lambdas.
class Exposure : public AstVisitor {
 public:
  Exposure(const Unit& unit, const NameParts& parts) : unit_(unit), parts_(parts) {
    exposed = llvm::any_of(parts.followed, [&](const clang::ValueDecl* decl) { return is_shared(decl); });
  }
  bool exposed;

  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    exposed = exposed || (llvm::is_contained(parts_.followed, reference->getDecl()) &&
                          !only_looks(unit_, reference) && !is_own_change(reference));
    return !exposed;
  }

 private:
  static bool is_shared(const clang::ValueDecl* decl) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
    if (!variable) return llvm::isa<clang::FieldDecl, clang::BindingDecl>(decl);
    return !variable->isLocalVarDeclOrParm() || variable->isStaticLocal() ||
           variable->getType()->isReferenceType();
  }
  bool is_own_change(const clang::DeclRefExpr* reference) const {
    const auto* change = parent_as<clang::Expr>(unit_.ast(), *reference);
    const auto* step = llvm::dyn_cast_or_null<clang::UnaryOperator>(change);
    const auto* assignment = llvm::dyn_cast_or_null<clang::BinaryOperator>(change);
    const bool assigns = assignment && assignment->isAssignmentOp() && assignment->getLHS() == reference;
    if (!assigns && !(step && step->isIncrementDecrementOp())) return false;
    for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *reference))
      if (node.get<clang::LambdaExpr>()) return false;
    return true;
  }
  const Unit& unit_;
  const NameParts& parts_;
};

bool is_exposed(const Unit& unit, const NameParts& parts, const clang::Stmt* body) {
  Exposure visitor(unit, parts);
  visitor.TraverseStmt(const_cast<clang::Stmt*>(body));
  return visitor.exposed;
}

/// Whether a call, or what it calls in turn, may change what a name depends on, or not come back.
class Reach : public AstVisitor {
 public:
  /// exposed: code that is not seen can change it.
  Reach(const Unit& unit, const std::vector<const clang::ValueDecl*>& decls, bool exposed)
      : unit_(unit), decls_(decls), exposed_(exposed) {}
  bool found = false, leaves = false;

  void call(const clang::FunctionDecl* callee, llvm::ArrayRef<const clang::Expr*> arguments) {
    for (const clang::Expr* argument : arguments) {
      const clang::CXXRecordDecl* record = argument->getType().getNonReferenceType()->getAsCXXRecordDecl();
      if (record && record->isLambda()) follow(record->getLambdaCallOperator());
    }
    if (!callee || unit_.declares(callee))
      follow(callee);
    else
      call_library(callee, arguments);
  }
  bool VisitStmt(clang::Stmt* stmt) override {
    leaves |= llvm::isa<clang::CXXThrowExpr>(stmt);
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* expr) override {
    call(expr->getDirectCallee(), {expr->getArgs(), expr->getNumArgs()});
    return !found;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    return note(reference, reference->getDecl());
  }
  bool VisitMemberExpr(clang::MemberExpr* member) override { return note(member, member->getMemberDecl()); }

 private:
  void call_library(const clang::FunctionDecl* callee, llvm::ArrayRef<const clang::Expr*> arguments) {
    const bool may_call_back = !calls_no_package_code(unit_, callee, arguments);
    found = found || (exposed_ && may_call_back);
    leaves = leaves || !comes_back(callee);
  }
  void follow(const clang::FunctionDecl* callee) {
    const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(callee);
    const clang::FunctionDecl* definition = nullptr;
    if (!callee || !callee->isDefined(definition) || (method && method->isVirtual()))
      found = found || exposed_, leaves = true;  // a function pointer, another file, another class
    else if (seen_.insert(definition).second)
      TraverseStmt(definition->getBody());
  }
  bool note(const clang::Expr* mention, const clang::ValueDecl* decl) {
    found = found || (llvm::is_contained(decls_, decl) && !only_looks(unit_, mention));
    return !found;
  }
  const Unit& unit_;
  const std::vector<const clang::ValueDecl*>& decls_;
  bool exposed_;
  std::set<const clang::FunctionDecl*> seen_;
};

struct Offsets {
  unsigned from, to;
};

/// The code between two offsets of a function: exits, and changes of what the publisher's name depends on.
class Between : public AstVisitor {
 public:
  Between(const Unit& unit, const NameParts& parts, bool exposed, Offsets range)
      : unit_(unit), parts_(parts), reach_(unit, parts.all, exposed), range_(range) {}
  bool leaves = false, changes = false, locks = false;
  std::set<std::string> callees;

  bool VisitStmt(clang::Stmt* stmt) override {
    const unsigned here = begin_of(unit_, stmt);
    if (here < range_.from || here >= range_.to) return true;
    leaves |= llvm::isa<clang::ReturnStmt, clang::BreakStmt, clang::ContinueStmt, clang::GotoStmt,
                        clang::CXXThrowExpr, clang::SwitchCase, clang::LabelStmt>(stmt);
    if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
      note(reference, reference->getDecl());
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt)) note(member, member->getMemberDecl());
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) note_call(call);
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) {
      reach_.call(made->getConstructor(), {made->getArgs(), made->getNumArgs()});
      note_callee(made->getConstructor());
    }
    locks |= may_synchronize(stmt);
    changes |= reach_.found;
    leaves |= reach_.leaves;
    return true;
  }

 private:
  void note_call(const clang::CallExpr* call) {
    const clang::FunctionDecl* callee = call->getDirectCallee();
    reach_.call(callee, {call->getArgs(), call->getNumArgs()});
    note_callee(callee);
    if (runs_window_callbacks(call)) callees.insert(window_callbacks);
  }
  void note_callee(const clang::FunctionDecl* callee) {
    const bool is_seen = unit_.declares_all_of(callee);
    if (!callee || unit_.declares(callee)) callees.insert(is_seen ? usr_of(pattern_of(callee)) : "");
  }
  void note(const clang::Expr* mention, const clang::ValueDecl* decl) {
    changes |= llvm::is_contained(parts_.all, decl) && !only_looks(unit_, mention);
  }
  const Unit& unit_;
  const NameParts& parts_;
  Reach reach_;
  Offsets range_;
};

/// A statement or operand that is not always evaluated when what is around it is.
bool is_optional_part(const clang::Stmt* part, const clang::Stmt* around) {
  if (const auto* statement = llvm::dyn_cast<clang::IfStmt>(around))
    return part == statement->getThen() || part == statement->getElse();
  if (const auto* choice = llvm::dyn_cast<clang::AbstractConditionalOperator>(around))
    return part != choice->getCond();
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(around))
    return op->isLogicalOp() && part == op->getRHS();
  return llvm::isa<clang::ForStmt, clang::WhileStmt, clang::CXXForRangeStmt, clang::SwitchStmt,
                   clang::CXXCatchStmt, clang::LambdaExpr>(around);
}

/// Whether every condition around the node is also one around the offset.
bool comes_with(const Unit& unit, const clang::Stmt* node, unsigned at) {
  clang::DynTypedNode part = clang::DynTypedNode::create(*node);
  for (const clang::DynTypedNode& ancestor : ancestors(unit.ast(), *node)) {
    if (ancestor.get<clang::FunctionDecl>()) return true;
    const auto* inner = part.get<clang::Stmt>();
    const auto* around = ancestor.get<clang::Stmt>();
    if (inner && around && is_optional_part(inner, around)) {
      const unsigned end = unit.offset(inner->getEndLoc());
      if (begin_of(unit, inner) > at || end < at) return false;
    }
    part = ancestor;
  }
  return true;
}

/// Finds a place that takes the same step whenever the offset is reached, before anything changes.
class StepFinder : public AstVisitor {
 public:
  StepFinder(const Unit& unit, const NameParts& parts, const clang::Stmt* body, const std::string& step,
             unsigned at)
      : unit_(unit),
        parts_(parts),
        body_(body),
        exposed_(is_exposed(unit, parts, body)),
        step_(step),
        at_(at) {}
  bool found = false;

  bool VisitStmt(clang::Stmt* stmt) override {
    found = found || (is_step(stmt) && step_text(unit_, stmt) == step_ && holds(stmt));
    return !found;
  }

 private:
  bool holds(const clang::Stmt* stmt) {
    if (!comes_with(unit_, stmt, at_)) return false;
    const unsigned here = begin_of(unit_, stmt);
    Between between(unit_, parts_, exposed_, {std::min(here, at_), std::max(here, at_)});
    between.TraverseStmt(const_cast<clang::Stmt*>(body_));
    return !between.changes && !between.locks && (here < at_ || !between.leaves);
  }
  const Unit& unit_;
  const NameParts& parts_;
  const clang::Stmt* body_;
  bool exposed_;
  const std::string& step_;
  unsigned at_;
};

}  // namespace

bool is_step(const clang::Stmt* stmt) {
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt))
    return member->isArrow() && !llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts());
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(stmt)) return op->getOpcode() == clang::UO_Deref;
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(stmt))
    return op->getOpcode() == clang::BO_Div || op->getOpcode() == clang::BO_Rem;
  return llvm::isa<clang::CXXOperatorCallExpr, clang::ArraySubscriptExpr>(stmt);
}

std::string step_text(const Unit& unit, const clang::Stmt* step) {
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(step);
  const auto* arrow = llvm::dyn_cast<clang::CXXOperatorCallExpr>(step);
  if (arrow && arrow->getOperator() != clang::OO_Arrow) arrow = nullptr;
  if (!member && !arrow) return unit.text(step);
  const clang::Expr* base = member ? member->getBase()->IgnoreImpCasts() : arrow->getArg(0);
  if (member && llvm::isa<clang::CXXOperatorCallExpr>(base)) return step_text(unit, base);
  return unit.text(base) + "->";
}

Waits MustExecute::waits_between(unsigned from, unsigned to) const {
  Between between(unit_, parts_, false, {from, to});
  between.TraverseStmt(const_cast<clang::Stmt*>(body_));
  return {between.locks, std::move(between.callees)};
}

bool MustExecute::changes_between(unsigned from, unsigned to) const {
  Between between(unit_, parts_, false, {from, to});
  between.TraverseStmt(const_cast<clang::Stmt*>(body_));
  return between.changes;
}

bool MustExecute::takes(const std::string& step, unsigned at) const {
  StepFinder visitor(unit_, parts_, body_, step, at);
  visitor.TraverseStmt(const_cast<clang::Stmt*>(body_));
  return visitor.found;
}

}  // namespace tzc::rewriter
