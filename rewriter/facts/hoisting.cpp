// SPDX-License-Identifier: BSD-3-Clause
#include "facts/hoisting.h"

#include "facts/must_execute.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// The local variable that an expression names; of a structured binding, what is taken apart.
const clang::VarDecl* local_of(const clang::Expr* expr) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
  if (!reference) return nullptr;
  const clang::ValueDecl* named = reference->getDecl();
  if (const auto* binding = llvm::dyn_cast<clang::BindingDecl>(named)) named = binding->getDecomposedDecl();
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(named);
  return variable && variable->isLocalVarDeclOrParm() ? variable : nullptr;
}

bool is_map(clang::QualType type) {
  const auto* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  return record && record->getName().ends_with("map");
}

/// pubs_[name] of a standard map. tzc::find_publisher(pubs_, name) finds the publisher without adding an
/// entry.
const clang::CXXOperatorCallExpr* lookup_of(const PublisherMention& publisher) {
  const clang::Expr* object = publisher.object->IgnoreParenImpCasts();
  const auto* lookup = llvm::dyn_cast<clang::CXXOperatorCallExpr>(object);
  if (publisher.pointer || !lookup || lookup->getOperator() != clang::OO_Subscript) return nullptr;
  const auto* map = lookup->getArg(0)->getType().getCanonicalType()->getAsCXXRecordDecl();
  const bool is_standard = map && (map->getName() == "map" || map->getName() == "unordered_map");
  return is_standard ? lookup : nullptr;
}

class PartsOf : public AstVisitor {
 public:
  explicit PartsOf(const Unit& unit) : unit_(unit) {}
  NameParts parts;

  bool VisitStmt(clang::Stmt* stmt) override {
    if (is_step(stmt)) parts.steps.insert(step_text(unit_, stmt));
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    if (const clang::VarDecl* local = local_of(reference)) parts.locals.push_back(local);
    parts.all.push_back(reference->getDecl());
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) override {
    parts.all.push_back(member->getMemberDecl());
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
    const auto kind = op ? op->getOperator() : clang::OO_None;
    parts.has_effects |= kind != clang::OO_Arrow && kind != clang::OO_Star &&
                         (kind != clang::OO_Subscript || is_map(op->getArg(0)->getType()));
    return true;
  }
  bool VisitUnaryOperator(clang::UnaryOperator* op) override {
    parts.has_effects |= op->isIncrementDecrementOp();
    return true;
  }

 private:
  const Unit& unit_;
};

NameParts parts_of(const Unit& unit, const PublisherMention& publisher) {
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
class Changes : public AstVisitor {
 public:
  Changes(const Unit& unit, const std::vector<const clang::VarDecl*>& variables, unsigned from, unsigned to)
      : unit_(unit), variables_(variables), from_(from), to_(to) {}
  bool found = false;

  bool VisitUnaryOperator(clang::UnaryOperator* op) override {
    if (op->isIncrementDecrementOp()) check(op->getSubExpr());
    return true;
  }
  bool VisitBinaryOperator(clang::BinaryOperator* op) override {
    if (op->isAssignmentOp()) check(op->getLHS());
    return true;
  }
  bool VisitCXXOperatorCallExpr(clang::CXXOperatorCallExpr* call) override {
    if (call->isAssignmentOp()) check(call->getArg(0));
    return true;
  }

 private:
  void check(const clang::Expr* target) {
    const clang::VarDecl* variable = local_of(target);
    if (!variable || !llvm::is_contained(variables_, variable)) return;
    const unsigned here = unit_.offset(target->getBeginLoc());
    found = found || (here > from_ && here < to_);
  }

  const Unit& unit_;
  const std::vector<const clang::VarDecl*>& variables_;
  unsigned from_, to_;
};

bool means_the_same(const Unit& unit, const PublisherMention& publisher, const NameParts& parts,
                    unsigned at) {
  for (const clang::VarDecl* local : parts.locals)
    if (unit.offset(local->getLocation()) >= at) return false;
  if (parts.locals.empty() || !publisher.function || !publisher.function->getBody()) return true;
  Changes changes(unit, parts.locals, at, publisher.begin);
  changes.TraverseStmt(publisher.function->getBody());
  return !changes.found;
}

}  // namespace

std::string Hoisting::name_text(const PublisherMention& publisher) const {
  const clang::CXXOperatorCallExpr* lookup = lookup_of(publisher);
  if (!lookup) return unit_.text(publisher.object);
  return "tzc::find_publisher(" + unit_.text(lookup->getArg(0)) + ", " + unit_.text(lookup->getArg(1)) + ")";
}

Availability Hoisting::availability_at(const PublisherMention& publisher, unsigned at) const {
  NameParts parts = parts_of(unit_, publisher);
  const clang::Stmt* body = publisher.function ? publisher.function->getBody() : nullptr;
  const MustExecute paths(unit_, parts, body);
  if (parts.has_effects || !means_the_same(unit_, publisher, parts, at)) return Availability::none;
  // Other threads may change a map while it is not locked.
  if (lookup_of(publisher) && body && paths.locks_between(at, publisher.begin)) return Availability::none;
  const bool can_be_asked =
      publisher.pointer && parts.steps.empty() && !publisher.object->getType()->isPointerType();
  if (publisher.pointer) parts.steps.insert(unit_.text(publisher.object) + "->");
  const bool always_taken =
      llvm::all_of(parts.steps, [&](const std::string& step) { return body && paths.takes(step, at); });
  if (always_taken) return Availability::safe;
  return can_be_asked ? Availability::guarded : Availability::none;
}

}  // namespace tzc::rewriter
