// SPDX-License-Identifier: BSD-3-Clause
// Whether the expression that names a publisher can be written earlier in the function, where a message is
// born: it must mean the same publisher there, change nothing, and not follow a pointer or an index that only
// holds where the publish call stands.
#include "facts/naming.h"

#include <clang/AST/RecursiveASTVisitor.h>

namespace tzc::rewriter {
namespace {

const clang::VarDecl* local_of(const clang::Expr* expr) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  return variable && variable->isLocalVarDeclOrParm() ? variable : nullptr;
}

bool is_map(clang::QualType type) {
  const auto* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  return record && record->getName().ends_with("map");
}

/// pubs_[name] of a standard map, which is named without adding an entry: tzc::find_publisher(pubs_, name).
const clang::CXXOperatorCallExpr* lookup_of(const SeenPublisher& publisher) {
  const clang::Expr* object = publisher.object->IgnoreParenImpCasts();
  const auto* lookup = llvm::dyn_cast<clang::CXXOperatorCallExpr>(object);
  if (publisher.pointer || !lookup || lookup->getOperator() != clang::OO_Subscript) return nullptr;
  const auto* map = lookup->getArg(0)->getType().getCanonicalType()->getAsCXXRecordDecl();
  const bool is_standard = map && (map->getName() == "map" || map->getName() == "unordered_map");
  return is_standard ? lookup : nullptr;
}

class PartsOf : public clang::RecursiveASTVisitor<PartsOf> {
 public:
  explicit PartsOf(Unit& unit) : unit_(unit) {}
  NameParts parts;

  bool VisitStmt(clang::Stmt* stmt) {
    if (is_step(stmt)) parts.steps.insert(step_text(unit_, stmt));
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) {
    if (const clang::VarDecl* local = local_of(reference)) parts.locals.push_back(local);
    parts.all.push_back(reference->getDecl());
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) {
    parts.all.push_back(member->getMemberDecl());
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) {
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
    const auto kind = op ? op->getOperator() : clang::OO_None;
    parts.has_effects |= kind != clang::OO_Arrow && kind != clang::OO_Star &&
                         (kind != clang::OO_Subscript || is_map(op->getArg(0)->getType()));
    return true;
  }
  bool VisitUnaryOperator(clang::UnaryOperator* op) {
    parts.has_effects |= op->isIncrementDecrementOp();
    return true;
  }

 private:
  Unit& unit_;
};

NameParts parts_of(Unit& unit, const SeenPublisher& publisher) {
  PartsOf visitor(unit);
  if (const clang::CXXOperatorCallExpr* lookup = lookup_of(publisher)) {
    visitor.TraverseStmt(const_cast<clang::Expr*>(lookup->getArg(0)));
    visitor.TraverseStmt(const_cast<clang::Expr*>(lookup->getArg(1)));
  } else {
    visitor.TraverseStmt(const_cast<clang::Expr*>(publisher.object));
  }
  return visitor.parts;
}

/// Whether one of the variables changes between two offsets of the function.
class Changes : public clang::RecursiveASTVisitor<Changes> {
 public:
  Changes(Unit& unit, const std::vector<const clang::VarDecl*>& variables, unsigned from, unsigned to)
      : unit_(unit), variables_(variables), from_(from), to_(to) {}
  bool found = false;

  bool VisitUnaryOperator(clang::UnaryOperator* op) {
    if (op->isIncrementDecrementOp()) check(op->getSubExpr());
    return true;
  }
  bool VisitBinaryOperator(clang::BinaryOperator* op) {
    if (op->isAssignmentOp()) check(op->getLHS());
    return true;
  }
  bool VisitCXXOperatorCallExpr(clang::CXXOperatorCallExpr* call) {
    if (call->isAssignmentOp()) check(call->getArg(0));
    return true;
  }

 private:
  void check(const clang::Expr* target) {
    const clang::VarDecl* variable = local_of(target);
    if (!variable || !llvm::is_contained(variables_, variable)) return;
    const unsigned here = unit_.source.where(target->getBeginLoc()).begin;
    found = found || (here > from_ && here < to_);
  }

  Unit& unit_;
  const std::vector<const clang::VarDecl*>& variables_;
  unsigned from_, to_;
};

bool means_the_same(Unit& unit, const SeenPublisher& publisher, const NameParts& parts, unsigned at) {
  for (const clang::VarDecl* local : parts.locals)
    if (unit.source.where(local->getLocation()).begin >= at) return false;
  if (parts.locals.empty() || !publisher.function || !publisher.function->getBody()) return true;
  Changes changes(unit, parts.locals, at, publisher.begin);
  changes.TraverseStmt(publisher.function->getBody());
  return !changes.found;
}

}  // namespace

std::string name_text(Unit& unit, const SeenPublisher& publisher) {
  const auto text = [&](const clang::Expr* expr) { return unit.source.text(expr->getSourceRange()); };
  const clang::CXXOperatorCallExpr* lookup = lookup_of(publisher);
  if (!lookup) return text(publisher.object);
  return "tzc::find_publisher(" + text(lookup->getArg(0)) + ", " + text(lookup->getArg(1)) + ")";
}

Naming naming_at(Unit& unit, const SeenPublisher& publisher, unsigned at) {
  NameParts parts = parts_of(unit, publisher);
  const clang::Stmt* body = publisher.function ? publisher.function->getBody() : nullptr;
  if (parts.has_effects || !means_the_same(unit, publisher, parts, at)) return Naming::none;
  // Others may change a map as long as it is not locked.
  if (lookup_of(publisher) && body && locks_between(unit, parts, body, at, publisher.begin))
    return Naming::none;
  const bool can_be_asked =
      publisher.pointer && parts.steps.empty() && !publisher.object->getType()->isPointerType();
  if (publisher.pointer) parts.steps.insert(unit.source.text(publisher.object->getSourceRange()) + "->");
  const bool taken_anyway = llvm::all_of(parts.steps, [&](const std::string& step) {
    return body && takes_step_anyway(unit, parts, body, step, at);
  });
  if (taken_anyway) return Naming::safe;
  return can_be_asked ? Naming::guarded : Naming::none;
}

}  // namespace tzc::rewriter
