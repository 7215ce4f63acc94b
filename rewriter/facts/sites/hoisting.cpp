// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/hoisting.h"

#include "facts/sites/lock_guarded.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/package_types.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

/// if (pointer), if (optional): an iterator has no such answer.
bool can_be_asked(clang::QualType type) {
  const clang::CXXRecordDecl* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition()) return false;
  return llvm::any_of(
      record->getDefinition()->getVisibleConversionFunctions(), [](const clang::NamedDecl* named) {
        const auto* conversion = llvm::dyn_cast<clang::CXXConversionDecl>(named->getUnderlyingDecl());
        return conversion && conversion->getConversionType()->isScalarType();
      });
}

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

bool is_sequence(clang::QualType type) {
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isConstantArrayType()) return true;
  const auto* record = type->getAsCXXRecordDecl();
  if (!record || !record->isInStdNamespace()) return false;
  return record->getName() == "vector" || record->getName() == "deque" || record->getName() == "array";
}

bool is_standard_map(clang::QualType type) {
  const auto* record = type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  return record && (record->getName() == "map" || record->getName() == "unordered_map");
}

std::optional<Lookup> lookup_by_method(const clang::CXXMemberCallExpr* call) {
  const clang::Expr* container = call->getImplicitObjectArgument();
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method || !method->getIdentifier() || container->getType()->isPointerType()) return {};
  const llvm::StringRef name = method->getName();
  const bool sequence = is_sequence(container->getType());
  if (name == "at" && call->getNumArgs() == 1 && (sequence || is_standard_map(container->getType())))
    return Lookup{container, call->getArg(0)};
  if (sequence && call->getNumArgs() == 0 && (name == "front" || name == "back"))
    return Lookup{container, nullptr, name == "back"};
  return {};
}

std::optional<Lookup> lookup_of(const PublisherMention& publisher) {
  if (publisher.pointer) return {};
  const clang::Expr* object = publisher.object->IgnoreParenImpCasts();
  if (const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(object)) return lookup_by_method(call);
  const clang::Expr* container = nullptr;
  const clang::Expr* key = nullptr;
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(object);
      op && op->getOperator() == clang::OO_Subscript && op->getNumArgs() == 2) {
    container = op->getArg(0);
    key = op->getArg(1);
  } else if (const auto* subscript = llvm::dyn_cast<clang::ArraySubscriptExpr>(object)) {
    container = subscript->getBase()->IgnoreParenImpCasts();
    key = subscript->getIdx();
  }
  if (!container || !(is_sequence(container->getType()) || is_standard_map(container->getType()))) return {};
  return Lookup{container, key};
}

/// A variable or member that never changes; a const reference shows an object that others may change.
bool is_constant(const clang::Expr* expr) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr);
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr);
  const clang::ValueDecl* decl = reference ? reference->getDecl()
                                 : member  ? member->getMemberDecl()
                                           : nullptr;
  return decl && decl->getType().isConstQualified();
}

/// What an expression mentions and reads decides where a step behind it leads.
void add_followed(NameParts& parts, const clang::Stmt* stmt) {
  if (!stmt) return;
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
    parts.followed.push_back(reference->getDecl());
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt))
    parts.followed.push_back(member->getMemberDecl());
  const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
  // Of an array nothing is read but its elements.
  const bool is_read = expr && expr->isGLValue() && !expr->getType()->isFunctionType() &&
                       !expr->getType()->isArrayType() && !is_constant(expr) &&
                       !llvm::isa<clang::ParenExpr, clang::ImplicitCastExpr>(expr);
  if (is_read) parts.read.push_back(expr);
  for (const clang::Stmt* child : stmt->children()) add_followed(parts, child);
}

/// What a step follows: the pointer, iterator or container a of a->b, *a, a[i]. Null: it follows none.
const clang::Expr* pointer_of(const clang::Stmt* step) {
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(step)) {
    const bool is_of_class = llvm::isa<clang::CXXOperatorCallExpr>(member->getBase()->IgnoreParenImpCasts());
    return is_of_class ? nullptr : member->getBase();  // its operator-> is a step of its own
  }
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(step)) return op->getSubExpr();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(step)) return op->getArg(0);
  const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(step);
  const bool is_of_array = element && element->getBase()->IgnoreParenImpCasts()->getType()->isArrayType();
  return element && !is_of_array ? element->getBase() : nullptr;
}

void add_led_to(NameParts& parts, const clang::Expr* pointer) {
  const clang::QualType type = pointer ? led_to_without_owning(pointer->getType()) : clang::QualType();
  if (!type.isNull() && !type->isFunctionType()) parts.led_to.push_back(type);
}

class PartsOf : public AstVisitor {
 public:
  explicit PartsOf(const Unit& unit) : unit_(unit) {}
  NameParts parts;

  bool VisitStmt(clang::Stmt* stmt) override {
    if (!is_step(stmt)) return true;
    parts.steps.insert(step_text(unit_, stmt));
    add_led_to(parts, pointer_of(stmt));
    for (const clang::Stmt* child : stmt->children()) add_followed(parts, child);
    return true;
  }
  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    if (const clang::VarDecl* local = local_of(reference)) parts.locals.push_back(local);
    note(reference, reference->getDecl());
    return true;
  }
  bool VisitMemberExpr(clang::MemberExpr* member) override {
    note(member, member->getMemberDecl());
    return true;
  }
  bool VisitCallExpr(clang::CallExpr* call) override {
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
    const auto kind = op ? op->getOperator() : clang::OO_None;
    parts.has_effects |= kind != clang::OO_Arrow && kind != clang::OO_Star &&
                         (kind != clang::OO_Subscript || is_map(op->getArg(0)->getType()));
    parts.has_effects |= op && unit_.declares(op->getDirectCallee());
    return true;
  }
  bool VisitUnaryOperator(clang::UnaryOperator* op) override {
    parts.has_effects |= op->isIncrementDecrementOp();
    return true;
  }
  bool VisitBinaryOperator(clang::BinaryOperator* op) override {
    parts.has_effects |= op->isAssignmentOp();
    return true;
  }
  /// A constructor of the package may do anything; std::string throws when it is given a null pointer.
  bool VisitCXXConstructExpr(clang::CXXConstructExpr* made) override {
    parts.has_effects |= unit_.declares(made->getConstructor()) && made->getConstructor()->isUserProvided();
    for (const clang::Expr* argument : made->arguments())
      parts.has_effects |= argument->getType()->isPointerType() &&
                           !llvm::isa<clang::StringLiteral>(argument->IgnoreParenImpCasts());
    return true;
  }

 private:
  /// A second look at what is volatile may do something, or see something else.
  void note(const clang::Expr* mention, const clang::ValueDecl* named) {
    parts.all.push_back(named);
    parts.has_effects |= mention->getType().isVolatileQualified();
  }

  const Unit& unit_;
};

NameParts parts_of(const Unit& unit, llvm::ArrayRef<const clang::Expr*> exprs) {
  PartsOf visitor(unit);
  for (const clang::Expr* expr : exprs)
    if (expr) visitor.TraverseStmt(const_cast<clang::Expr*>(expr));
  return visitor.parts;
}

/// Finds a variable that changes between two offsets of the function.
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
    found |= here > from_ && here < to_;
  }

  const Unit& unit_;
  const std::vector<const clang::VarDecl*>& variables_;
  unsigned from_, to_;
};

/// Of the function that mentions it; null: it stands outside of functions.
const clang::Stmt* body_around(const PublisherMention& publisher) {
  return publisher.function ? publisher.function->getBody() : nullptr;
}

/// Whether a variable of the name is not there yet, or means something else then.
bool has_changed_local(const Unit& unit, const PublisherMention& publisher, const NameParts& parts,
                       unsigned at) {
  for (const clang::VarDecl* local : parts.locals)
    if (unit.offset(local->getLocation()) >= at) return true;
  const clang::Stmt* body = body_around(publisher);
  if (parts.locals.empty() || !body) return false;
  Changes changes(unit, parts.locals, std::min(at, publisher.begin), std::max(at, publisher.begin));
  changes.TraverseStmt(const_cast<clang::Stmt*>(body));
  return changes.found;
}

}  // namespace

std::optional<EarlyName> Hoisting::name_at(const PublisherMention& publisher, unsigned at) const {
  if (std::optional<EarlyName> name = as_written_at(publisher, at)) return name;
  const std::optional<Lookup> lookup = lookup_of(publisher);
  return lookup ? looked_up_at(publisher, *lookup, at) : std::nullopt;
}

bool Hoisting::names_the_same(const clang::Expr* object, const clang::FunctionDecl* function,
                              unsigned at) const {
  const std::optional<EarlyName> name =
      as_written_at({object, false, {}, {}, function, unit_.offset(object->getBeginLoc())}, at);
  return name && !name->guarded;
}

bool Hoisting::means_the_same(const PublisherMention& publisher, const NameParts& parts, unsigned at) const {
  return !parts.has_effects && !has_changed_local(unit_, publisher, parts, at);
}

std::optional<EarlyName> Hoisting::as_written_at(const PublisherMention& publisher, unsigned at) const {
  NameParts parts = parts_of(unit_, publisher.object);
  const std::string text = unit_.text(publisher.object);  // none: a macro's body names it
  if (text.empty() || !means_the_same(publisher, parts, at)) return {};
  const bool may_guard =
      publisher.pointer && parts.steps.empty() && can_be_asked(publisher.object->getType());
  if (publisher.pointer) {
    parts.steps.insert(text + "->");
    add_led_to(parts, publisher.object);
    add_followed(parts, publisher.object);
  }
  const bool valid = takes_steps(publisher, parts, at);
  if (!valid && (!may_guard || comes_later(publisher, parts, at))) return {};
  Waits waits = waits_between(publisher, parts, at);
  if (valid && !may_change_elsewhere(parts)) waits = {};
  if (waits.locks) return {};
  return EarlyName{text, !valid, std::move(waits.callees)};
}

/// Whether a variable of this call may get its publisher between the offset and the mention: asked there, it would be null in each call. A
/// member, or a static variable, has it from the second call on.
bool Hoisting::comes_later(const PublisherMention& publisher, const NameParts& parts, unsigned at) const {
  const clang::VarDecl* local = local_of(publisher.object);
  if (!local || local->getType()->isReferenceType() || local->isStaticLocal()) return false;
  const unsigned mentioned = unit_.offset(publisher.object->getBeginLoc());
  const clang::Stmt* body = body_around(publisher);
  return !body ||
         MustExecute(unit_, parts, body).may_change_between(std::min(at, mentioned), std::max(at, mentioned));
}

bool Hoisting::may_change_elsewhere(const NameParts& parts) const {
  return llvm::any_of(parts.all,
                      [&](const clang::ValueDecl* named) { return may_be_lock_guarded(unit_, named); });
}

/// Whether the offset is in the whole expression that mentions the publisher.
bool Hoisting::is_in_expression_of(const PublisherMention& publisher, unsigned at) const {
  const clang::Expr* whole = publisher.object;
  while (const auto* around = parent_as<clang::Expr>(unit_.ast(), *whole)) whole = around;
  return at >= unit_.offset(whole->getBeginLoc()) && at <= unit_.offset(whole->getEndLoc());
}

/// Other threads may change a publisher or a pointer while it is not locked, unless it is a variable of this function.
Waits Hoisting::waits_between(const PublisherMention& publisher, const NameParts& parts, unsigned at) const {
  const clang::VarDecl* local = local_of(publisher.object);
  if (local && !local->getType()->isReferenceType() && !local->isStaticLocal()) return {};
  const clang::Stmt* body = body_around(publisher);
  if (!body) return {true, {}};
  const unsigned mentioned = unit_.offset(publisher.object->getBeginLoc());
  // A lock before an earlier mention may be gone, unless the mention is part of the same expression.
  const unsigned from = mentioned >= at ? at : is_in_expression_of(publisher, at) ? mentioned : 0;
  return MustExecute(unit_, parts, body).waits_between(from, std::max(mentioned, at));
}

std::optional<EarlyName> Hoisting::looked_up_at(const PublisherMention& publisher, const Lookup& lookup,
                                                unsigned at) const {
  const NameParts parts = parts_of(unit_, {lookup.container, lookup.key});
  if (!means_the_same(publisher, parts, at)) return {};
  // A function of the package would compare the key.
  if (involves_package(unit_, lookup.container->getType())) return {};
  // Allocated from another publisher, the message would take that one's room. Other threads may change a container while it is not locked.
  const clang::Stmt* body = body_around(publisher);
  const MustExecute between(unit_, parts, body);
  const unsigned mentioned = unit_.offset(publisher.object->getBeginLoc());
  const std::string container = unit_.text(lookup.container);
  if (body && (between.changes_between(at, mentioned) || between.waits_between(at, mentioned).locks))
    return {};
  if (!takes_steps(publisher, parts, at)) return {};
  std::string key = lookup.is_last ? container + ".size() - 1" : "0";
  if (lookup.key) key = unit_.text(lookup.key);
  return EarlyName{"tzc::find_publisher(" + container + ", " + key + ")"};
}

bool Hoisting::takes_steps(const PublisherMention& publisher, const NameParts& parts, unsigned at) const {
  const clang::Stmt* body = body_around(publisher);
  const MustExecute paths(unit_, parts, body);
  return llvm::all_of(parts.steps, [&](const auto& step) { return body && paths.takes(step, at); });
}

}  // namespace tzc::rewriter
