// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/must_execute.h"

#include <algorithm>
#include <limits>

#include "facts/sites/may_leave.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/lock_names.h"
#include "facts/syntax/package_types.h"
#include "facts/syntax/window_callbacks.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

unsigned begin_of(const Unit& unit, const clang::Stmt* stmt) {
  return unit.offset(stmt->getBeginLoc());
}

/// A loop that only a jump ends.
bool is_endless(const Unit& unit, const clang::Stmt* stmt) {
  const clang::Expr* condition = nullptr;
  if (const auto* loop = llvm::dyn_cast<clang::ForStmt>(stmt)) {
    if (!loop->getCond()) return true;
    condition = loop->getCond();
  }
  if (const auto* loop = llvm::dyn_cast<clang::WhileStmt>(stmt)) condition = loop->getCond();
  if (const auto* loop = llvm::dyn_cast<clang::DoStmt>(stmt)) condition = loop->getCond();
  bool holds = false;
  return condition && !condition->isValueDependent() &&
         condition->EvaluateAsBooleanCondition(holds, unit.ast()) && holds;
}

/// Whether the end of an object of the type may run a destructor that the package writes: its own, or that of a part, of an
/// element, of what it owns; or of a class that the type does not show.
bool runs_package_at_end(const Unit& unit, clang::QualType type, unsigned depth = 0) {
  constexpr unsigned deep = 6;
  type = unit.ast().getBaseElementType(type.getNonReferenceType()).getCanonicalType();
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  const bool in_package = record && unit.source.in_package(record->getLocation());
  const auto calls = [](const clang::CXXMethodDecl* method) {
    return method->getOverloadedOperator() == clang::OO_Call;
  };
  if (in_package && depth > 0 && record->hasDefinition() && llvm::any_of(record->methods(), calls))
    return true;  // a deleter
  if (!record || (record->hasDefinition() && record->hasTrivialDestructor())) return type->isDependentType();
  if (!record->hasDefinition() || depth > deep || record->getName() == "function") return true;
  const clang::CXXDestructorDecl* destructor = record->getDestructor();
  const auto runs = [&](clang::QualType part) { return runs_package_at_end(unit, part, depth + 1); };
  if (in_package)
    return (destructor && (destructor->isUserProvided() || may_end_derived(destructor))) ||
           llvm::any_of(record->fields(), [&](const auto* field) { return runs(field->getType()); }) ||
           llvm::any_of(record->bases(), [&](const auto& base) { return runs(base.getType()); });
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && llvm::any_of(made->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& one) {
           return one.getKind() == clang::TemplateArgument::Type && runs(one.getAsType());
         });
}

/// The name of a publisher, and whether code that is not seen may change it.
struct WatchedName {
  const NameParts& parts;
  const NameReads& reads;
  bool exposed;
};

/// Whether a call, or what it calls in turn, may change what a name depends on, or not come back.
class Reach : public AstVisitor {
 public:
  Reach(const Unit& unit, const WatchedName& name) : unit_(unit), name_(name) {}
  bool found = false, leaves = false;

  void call(const clang::FunctionDecl* callee, llvm::ArrayRef<const clang::Expr*> arguments) {
    for (const clang::Expr* argument : arguments) {
      const clang::CXXRecordDecl* record = argument->getType().getNonReferenceType()->getAsCXXRecordDecl();
      if (record && record->isLambda()) follow(record->getLambdaCallOperator());
      // It stands at no place of the function.
      if (const auto* given = llvm::dyn_cast<clang::CXXDefaultArgExpr>(argument))
        TraverseStmt(const_cast<clang::Expr*>(given->getExpr()));
    }
    if (!callee || unit_.declares(callee))
      follow(callee);
    else
      call_library(callee, arguments);
  }
  /// The destructor of an object of the type runs.
  void end_of(clang::QualType type) {
    const clang::CXXRecordDecl* record = unit_.ast().getBaseElementType(type)->getAsCXXRecordDecl();
    if (!record || !record->hasDefinition() || record->hasTrivialDestructor()) return;
    const clang::CXXDestructorDecl* destructor = record->getDestructor();
    if (destructor && destructor->isUserProvided() && unit_.declares(destructor)) {
      const bool left = leaves;
      follow(destructor);
      leaves =
          left || destructor->getExceptionSpecType() == clang::EST_NoexceptFalse;  // else nothing leaves it
    } else {
      found = found || (name_.exposed && runs_package_at_end(unit_, type));
    }
  }
  /// What the statement itself does, wherever it stands.
  void look_at(const clang::Stmt* stmt) {
    found = found || name_.reads.may_be_changed_by(stmt);
    leaves = leaves || may_leave(unit_, stmt);
    if (const auto* call_of = llvm::dyn_cast<clang::CallExpr>(stmt))
      call(call_of->getDirectCallee(), {call_of->getArgs(), call_of->getNumArgs()});
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) {
      call(made->getConstructor(), {made->getArgs(), made->getNumArgs()});
      end_of(made->getType());
    }
    if (const auto* ended = llvm::dyn_cast<clang::CXXDeleteExpr>(stmt)) end_of(ended->getDestroyedType());
    if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(stmt)) end_of(bound->getType());
    if (const auto* given = llvm::dyn_cast<clang::CXXDefaultInitExpr>(stmt))
      TraverseStmt(const_cast<clang::Expr*>(given->getExpr()));
  }
  bool VisitStmt(clang::Stmt* stmt) override {
    leaves = leaves || is_endless(unit_, stmt);
    look_at(stmt);
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    return note(reference, reference->getDecl());
  }
  bool VisitMemberExpr(clang::MemberExpr* member) override { return note(member, member->getMemberDecl()); }

 private:
  void call_library(const clang::FunctionDecl* callee, llvm::ArrayRef<const clang::Expr*> arguments) {
    const bool may_call_back = !calls_no_package_code(unit_, callee, arguments);
    found = found || (name_.exposed && may_call_back);
    leaves = leaves || !surely_returns(unit_, callee, arguments);
  }
  void follow(const clang::FunctionDecl* callee) {
    const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(callee);
    if (method && method->isTrivial()) return;  // it copies an object that look_at() sees
    const clang::FunctionDecl* definition = callee ? shown_body(callee) : nullptr;
    if (!definition || (method && method->isVirtual())) {
      found = found || name_.exposed;  // a function pointer, another file, another class
      leaves = true;
      return;
    }
    if (!seen_.insert(definition).second) return;
    if (const auto* constructor = llvm::dyn_cast<clang::CXXConstructorDecl>(definition))
      for (const clang::CXXCtorInitializer* initializer : constructor->inits())
        TraverseStmt(initializer->getInit());
    TraverseStmt(definition->getBody());
  }
  bool note(const clang::Expr* mention, const clang::ValueDecl* decl) {
    found = found || (llvm::is_contained(name_.parts.all, decl) && !only_looks(unit_, mention));
    return true;
  }
  const Unit& unit_;
  const WatchedName name_;
  std::set<const clang::FunctionDecl*> seen_;
};

struct Offsets {
  unsigned from, to;
};

/// The code between two offsets of a function: exits, and changes of what the publisher's name depends on.
class Between : public AstVisitor {
 public:
  Between(const Unit& unit, const WatchedName& name, Offsets range)
      : unit_(unit), parts_(name.parts), reach_(unit, name), range_(range) {}
  bool leaves = false, changes = false, locks = false;
  bool enters = false;  ///< by a label, from somewhere else
  std::set<std::string> callees;

  bool VisitStmt(clang::Stmt* stmt) override {
    if (const auto* block = llvm::dyn_cast<clang::CompoundStmt>(stmt)) end_of(block);
    const unsigned here = begin_of(unit_, stmt);
    if (here < range_.from || here >= range_.to) return true;
    enters |= llvm::isa<clang::SwitchCase, clang::LabelStmt>(stmt);
    leaves |= enters || is_endless(unit_, stmt) ||
              llvm::isa<clang::ReturnStmt, clang::BreakStmt, clang::ContinueStmt, clang::GotoStmt,
                        clang::IndirectGotoStmt, clang::CoreturnStmt>(stmt);
    if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
      note(reference, reference->getDecl());
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt)) note(member, member->getMemberDecl());
    note_callees(stmt);
    locks |= may_synchronize(stmt);
    reach_.look_at(stmt);
    changes |= reach_.found;
    leaves |= reach_.leaves;
    return true;
  }

 private:
  /// What a block has declared ends with it.
  void end_of(const clang::CompoundStmt* block) {
    const unsigned end = unit_.offset(block->getEndLoc());
    if (end < range_.from || end >= range_.to) return;
    for (const clang::Stmt* stmt : block->body())
      if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt))
        for (const clang::Decl* decl : declaration->decls())
          if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
              variable && variable->hasLocalStorage())
            reach_.end_of(object_type_of(variable));
    changes |= reach_.found;
  }
  void note_callees(const clang::Stmt* stmt) {
    if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) note_callee(made->getConstructor());
    const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
    if (!call) return;
    note_callee(call->getDirectCallee());
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

/// Widens a range by the loops that have one of its ends, and not the other one: their bodies run again between the two. Where a label
/// stands anything may run again.
class Rounds : public AstVisitor {
 public:
  Rounds(const Unit& unit, Offsets range) : range(range), unit_(unit), ends_(range) {}
  Offsets range;

  bool VisitStmt(clang::Stmt* stmt) override {
    if (llvm::isa<clang::LabelStmt>(stmt)) range = {0, std::numeric_limits<unsigned>::max()};
    if (!llvm::isa<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt>(stmt))
      return true;
    const unsigned begin = begin_of(unit_, stmt), end = unit_.offset(stmt->getEndLoc());
    const auto has = [&](unsigned at) { return begin <= at && at <= end; };
    if (has(ends_.from) == has(ends_.to)) return true;
    range.from = std::min(range.from, begin);
    range.to = std::max(range.to, end);
    return true;
  }

 private:
  const Unit& unit_;
  const Offsets ends_;
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

/// Whether every condition around the node is also one around the offset, and every block before the offset that is tried.
bool comes_with(const Unit& unit, const clang::Stmt* node, unsigned at) {
  clang::DynTypedNode part = clang::DynTypedNode::create(*node);
  for (const clang::DynTypedNode& ancestor : ancestors(unit.ast(), *node)) {
    if (ancestor.get<clang::FunctionDecl>()) return true;
    const auto* inner = part.get<clang::Stmt>();
    const auto* around = ancestor.get<clang::Stmt>();
    const bool is_tried = around && llvm::isa<clang::CXXTryStmt>(around) && begin_of(unit, node) < at;
    if (inner && around && (is_tried || is_optional_part(inner, around))) {
      const unsigned end = unit.offset(inner->getEndLoc());
      if (begin_of(unit, inner) > at || end < at) return false;
    }
    part = ancestor;
  }
  return true;
}

/// The variable or member that a path of names leads to: pub_, this->pub_, outputs.left.
bool is_path_of_objects(const clang::Expr* expr) {
  expr = expr->IgnoreParens();
  if (llvm::isa<clang::CXXThisExpr>(expr) || llvm::isa<clang::DeclRefExpr>(expr)) return true;
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  if (!member || !llvm::isa<clang::FieldDecl>(member->getMemberDecl())) return false;
  const clang::Expr* base = member->getBase()->IgnoreParens();
  return member->isArrow() ? llvm::isa<clang::CXXThisExpr>(base->IgnoreImpCasts()) : is_path_of_objects(base);
}

/// Whether a pointer that is made with the value leads to an object: of one that is just made, or has a name.
bool leads_to_object(const clang::Expr* value) {
  value = value->IgnoreImplicit();
  if (const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(value))
    return made->getNumPlacementArgs() == 0 && !made->shouldNullCheckAllocation();
  if (const auto* address = llvm::dyn_cast<clang::UnaryOperator>(value))
    return address->getOpcode() == clang::UO_AddrOf && is_path_of_objects(address->getSubExpr());
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(value)) return makes_object(call);
  const auto* copy = llvm::dyn_cast<clang::CXXConstructExpr>(value);
  return copy && copy->getNumArgs() > 0 && leads_to_object(copy->getArg(0));
}

/// Finds a place that takes the same step whenever the offset is reached, before anything changes.
class StepFinder : public AstVisitor {
 public:
  StepFinder(const Unit& unit, const NameParts& parts, const NameReads& reads, const clang::Stmt* body,
             const std::string& step, unsigned at)
      : unit_(unit), parts_(parts), reads_(reads), body_(body), step_(step), at_(at) {}
  bool found = false;

  bool VisitStmt(clang::Stmt* stmt) override {
    found = found || (is_step(stmt) && step_text(unit_, stmt) == step_ && holds(stmt, begin_of(unit_, stmt)));
    return !found;
  }
  /// A local pointer that is made with an object is as good as one that was followed.
  bool VisitVarDecl(clang::VarDecl* variable) override {
    const clang::Expr* value = variable->getInit();
    const std::string name = variable->getNameAsString();
    if (!value || !variable->hasLocalStorage() || variable->getType()->isReferenceType() ||
        !llvm::is_contained(parts_.locals, variable) || (step_ != name + "->" && step_ != "*" + name))
      return !found;
    const unsigned end = unit_.offset(variable->getEndLoc()) + 1;
    found = found || (end <= at_ && leads_to_object(value) && holds(value, end));
    return !found;
  }

 private:
  bool holds(const clang::Stmt* stmt, unsigned here) {
    if (!comes_with(unit_, stmt, at_)) return false;
    Rounds rounds(unit_, {std::min(here, at_), std::max(here, at_)});
    rounds.TraverseStmt(const_cast<clang::Stmt*>(body_));
    Between between(unit_, {parts_, reads_, reads_.is_exposed()}, rounds.range);
    between.TraverseStmt(const_cast<clang::Stmt*>(body_));
    return !between.changes && !between.locks && !(here < at_ ? between.enters : between.leaves);
  }
  const Unit& unit_;
  const NameParts& parts_;
  const NameReads& reads_;
  const clang::Stmt* body_;
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
  Between between(unit_, {parts_, reads_, false}, {from, to});
  between.TraverseStmt(const_cast<clang::Stmt*>(body_));
  return {between.locks, std::move(between.callees)};
}

bool MustExecute::changes_between(unsigned from, unsigned to) const {
  Between between(unit_, {parts_, reads_, false}, {from, to});
  between.TraverseStmt(const_cast<clang::Stmt*>(body_));
  return between.changes;
}

bool MustExecute::may_change_between(unsigned from, unsigned to) const {
  Between between(unit_, {parts_, reads_, reads_.is_exposed()}, {from, to});
  between.TraverseStmt(const_cast<clang::Stmt*>(body_));
  return between.changes;
}

bool MustExecute::takes(const std::string& step, unsigned at) const {
  StepFinder visitor(unit_, parts_, reads_, body_, step, at);
  visitor.TraverseStmt(const_cast<clang::Stmt*>(body_));
  return visitor.found;
}

}  // namespace tzc::rewriter
