// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/name_reads.h"

#include "facts/syntax/ast_walk.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

clang::QualType plain(const Unit& unit, clang::QualType type) {
  return unit.ast().getBaseElementType(type.getNonReferenceType()).getCanonicalType().getUnqualifiedType();
}

bool holds(const Unit& unit, clang::QualType type, clang::QualType part, unsigned depth = 0);

bool holds(const Unit& unit, const clang::TemplateArgument& argument, clang::QualType part, unsigned depth) {
  if (argument.getKind() == clang::TemplateArgument::Pack)
    return llvm::any_of(argument.pack_elements(),
                        [&](const clang::TemplateArgument& one) { return holds(unit, one, part, depth); });
  if (argument.getKind() != clang::TemplateArgument::Type) return false;
  const clang::QualType type = argument.getAsType();
  const bool leads_on = type->isPointerType() && !type->getPointeeType().isConstQualified();
  return holds(unit, type, part, depth) || (leads_on && holds(unit, type->getPointeeType(), part, depth));
}

/// Whether an object of the type has a part of the other type, or keeps such objects as a container does.
bool holds(const Unit& unit, clang::QualType type, clang::QualType part, unsigned depth) {
  constexpr unsigned deep = 8;
  type = plain(unit, type);
  if (type == part || depth > deep || type->isDependentType()) return true;
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition()) return false;
  const auto has = [&](clang::QualType inner) { return holds(unit, inner, part, depth + 1); };
  if (unit.source.in_package(record->getLocation()) &&
      llvm::any_of(record->fields(), [&](const clang::FieldDecl* field) { return has(field->getType()); }))
    return true;
  if (llvm::any_of(record->bases(), [&](const clang::CXXBaseSpecifier& base) { return has(base.getType()); }))
    return true;
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && llvm::any_of(made->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& one) {
           return holds(unit, one, part, depth + 1);
         });
}

const clang::ValueDecl* root_of(const clang::Expr* expr);

/// A variable or field that is no other name of something; null: it is one.
const clang::ValueDecl* root_of(const clang::ValueDecl* decl) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(decl);
  const bool is_object = field ? !field->getParent()->isUnion() : llvm::isa<clang::VarDecl>(decl);
  if (!is_object || decl->getType()->isReferenceType()) return nullptr;
  return llvm::cast<clang::ValueDecl>(decl->getCanonicalDecl());  // a global may be declared several times
}

/// The variable or field that has the object, or whose element it is; null: none that is seen.
const clang::ValueDecl* root_of(const clang::Expr* expr) {
  expr = expr->IgnoreParens();
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(expr))
    return cast->isGLValue() || cast->getCastKind() == clang::CK_ArrayToPointerDecay
               ? root_of(cast->getSubExpr())
               : nullptr;
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return root_of(name->getDecl());
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return root_of(member->getMemberDecl());
  const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr);
  return element ? root_of(element->getBase()) : nullptr;
}

/// values[i] of a container, which has its elements to itself.
bool is_owned_element(const clang::Expr* expr) {
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr->IgnoreParens());
  if (!op || op->getOperator() != clang::OO_Subscript) return false;
  const clang::CXXRecordDecl* record = op->getArg(0)->getType()->getAsCXXRecordDecl();
  static constexpr llvm::StringRef owners[] = {"vector", "deque",         "array",
                                               "map",    "unordered_map", "basic_string"};
  return record && record->isInStdNamespace() && record->getIdentifier() &&
         llvm::is_contained(owners, record->getName());
}

bool leads_only(clang::OverloadedOperatorKind op) {
  return op == clang::OO_Subscript || op == clang::OO_Arrow || op == clang::OO_Star;
}

/// What it yields leads to elements, and a change of these is seen where it is made.
bool leads_only(const clang::FunctionDecl* callee) {
  static constexpr llvm::StringRef names[] = {"begin", "end", "rbegin", "rend", "data",       "front",
                                              "back",  "at",  "find",   "get",  "lower_bound"};
  return leads_only(callee->getOverloadedOperator()) ||
         (callee->getIdentifier() && llvm::is_contained(names, callee->getName()));
}

/// The element of an array that a mention of the array is part of; null: it is something else.
const clang::ArraySubscriptExpr* element_around(const Unit& unit, const clang::Expr* array) {
  const auto* around = parent_as<clang::Expr>(unit.ast(), *array);
  while (llvm::isa_and_nonnull<clang::ParenExpr>(around) ||
         (around && llvm::isa<clang::ImplicitCastExpr>(around) && !around->isGLValue() &&
          around->getType()->isPointerType()))
    around = parent_as<clang::Expr>(unit.ast(), *around);
  return llvm::dyn_cast_or_null<clang::ArraySubscriptExpr>(around);
}

/// Variables of the function that another name may lead to, or that a closure changes. One that is only read, or assigned under its
/// own name outside of closures, has no other name.
class TakenAddresses : public AstVisitor {
 public:
  TakenAddresses(const Unit& unit, const NameParts& parts, const clang::Stmt* body)
      : unit_(unit), parts_(parts), body_(body) {}
  std::set<const clang::ValueDecl*> found;

  bool VisitDeclRefExpr(clang::DeclRefExpr* reference) override {
    const clang::ValueDecl* decl = reference->getDecl();
    if (llvm::is_contained(parts_.followed, decl) &&
        (is_of_another_function(reference) || gives_element_away(reference) ||
         (!only_looks(unit_, reference) && !is_own_change(reference))))
      found.insert(decl);
    return true;
  }

 private:
  /// A captured variable: the function around may have given it away.
  bool is_of_another_function(const clang::DeclRefExpr* reference) const {
    const unsigned at = unit_.offset(reference->getDecl()->getLocation());
    return reference->refersToEnclosingVariableOrCapture() &&
           (at < unit_.offset(body_->getBeginLoc()) || at > unit_.offset(body_->getEndLoc()));
  }
  /// &pubs[0], a reference to pubs[0]; not pubs[0] = &pub, pubs[0].reset()
  bool gives_element_away(const clang::DeclRefExpr* reference) const {
    if (!reference->getType()->isArrayType()) return false;
    const clang::Expr* element = element_around(unit_, reference);
    while (element && element->getType()->isArrayType()) element = element_around(unit_, element);
    if (!element || only_looks(unit_, element)) return !element;
    const auto* around = parent_as<clang::Expr>(unit_.ast(), *element);
    return !llvm::isa_and_nonnull<clang::MemberExpr>(around) && !is_own_change(element);
  }
  bool is_own_change(const clang::Expr* reference) const {
    const auto* change = parent_as<clang::Expr>(unit_.ast(), *reference);
    const auto* step = llvm::dyn_cast_or_null<clang::UnaryOperator>(change);
    const auto* assignment = llvm::dyn_cast_or_null<clang::BinaryOperator>(change);
    const auto* call = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(change);
    const bool calls = call && call->getArg(0) == reference &&
                       (call->isAssignmentOp() || call->getOperator() == clang::OO_PlusPlus ||
                        call->getOperator() == clang::OO_MinusMinus);
    const bool assigns = assignment && assignment->isAssignmentOp() && assignment->getLHS() == reference;
    if (!calls && !assigns && !(step && step->isIncrementDecrementOp())) return false;
    for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *reference))
      if (node.get<clang::LambdaExpr>()) return false;
    return true;
  }
  const Unit& unit_;
  const NameParts& parts_;
  const clang::Stmt* body_;
};

bool is_shared(const clang::ValueDecl* decl) {
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  return !variable || !variable->isLocalVarDeclOrParm() || variable->isStaticLocal();
}

}  // namespace

clang::QualType led_to_without_owning(clang::QualType pointer) {
  pointer = pointer.getNonReferenceType().getCanonicalType();
  if (pointer->isPointerType()) return pointer->getPointeeType();
  const clang::CXXRecordDecl* record = pointer->getAsCXXRecordDecl();
  if (!record || !record->hasDefinition()) return {};
  clang::QualType result;
  for (const clang::CXXMethodDecl* method : record->getDefinition()->methods()) {
    const auto* conversion = llvm::dyn_cast<clang::CXXConversionDecl>(method);
    if (conversion && conversion->getConversionType()->isBooleanType())
      return {};  // it may be empty: an owner
    if (method->getOverloadedOperator() == clang::OO_Arrow) result = method->getReturnType();
  }
  return !result.isNull() && result->isPointerType() ? result->getPointeeType() : clang::QualType();
}

bool only_looks(const Unit& unit, const clang::Expr* mention) {
  if (mention->getType().isConstQualified()) return true;
  const auto* around = parent_as<clang::Expr>(unit.ast(), *mention);
  if (!around) return false;
  if (llvm::isa<clang::ParenExpr>(around)) return only_looks(unit, around);
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(around)) {
    if (cast->getCastKind() == clang::CK_ArrayToPointerDecay)
      return element_around(unit, mention) || cast->getType()->getPointeeType().isConstQualified();
    return !cast->isGLValue() || cast->getType().isConstQualified() || only_looks(unit, cast);
  }
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(around)) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(member->getMemberDecl());
    return !method || method->isConst() || member->isArrow();
  }
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(around);
  return op ? leads_only(op->getOperator()) : llvm::isa<clang::ArraySubscriptExpr>(around);
}

NameReads::NameReads(const Unit& unit, const NameParts& parts, const clang::Stmt* body) : unit_(unit) {
  TakenAddresses taken(unit, parts, body);
  if (body && !parts.read.empty()) taken.TraverseStmt(const_cast<clang::Stmt*>(body));
  for (const clang::Expr* expr : parts.read) {
    const clang::ValueDecl* root = root_of(expr);
    reads_.push_back(
        {root, plain(unit, expr->getType()), !root || is_shared(root) || taken.found.count(root)});
  }
  for (const clang::QualType type : parts.led_to) led_to_.push_back(plain(unit, type));
}

bool NameReads::is_exposed() const {
  return !led_to_.empty() || llvm::any_of(reads_, [](const Read& read) { return read.exposed; });
}

bool NameReads::may_be_changed_by(const clang::Stmt* stmt) const {
  if (reads_.empty()) return false;
  if (llvm::isa<clang::AsmStmt>(stmt)) return true;
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(stmt))
    return op->isAssignmentOp() && by_store(op->getLHS());
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(stmt))
    return op->isIncrementDecrementOp() && by_store(op->getSubExpr());
  if (const auto* ended = llvm::dyn_cast<clang::CXXDeleteExpr>(stmt))
    return is_led_to(ended->getDestroyedType()) || by_store_to_any(ended->getDestroyedType());
  if (const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(stmt))
    return made->getNumPlacementArgs() > 0 &&
           (is_led_to(made->getAllocatedType()) || by_store_to_any(made->getAllocatedType()));
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return !made->getConstructor()->isCopyConstructor() &&
           by_arguments(made->getConstructor(), {made->getArgs(), made->getNumArgs()});
  const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
  return call && by_call(call);
}

/// What the package declares is followed, or is not seen. What the compiler writes for a class assigns the whole object.
bool NameReads::by_call(const clang::CallExpr* call) const {
  const clang::FunctionDecl* callee = call->getDirectCallee();
  llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(callee);
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(call);
  if (op && op->isAssignmentOp() && by_store(op->getArg(0))) return true;
  if (!callee) return false;
  const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::Expr* object = member ? member->getImplicitObjectArgument() : nullptr;
  if (op && method && !method->isStatic()) {
    object = arguments[0];
    arguments = arguments.drop_front();
  }
  if (object && method && !method->isConst() && !leads_only(method) && !unit_.declares(callee) &&
      (object->getType()->isPointerType() ? by_store_to_any(object->getType()->getPointeeType())
                                          : by_store(object->IgnoreImpCasts())))
    return true;
  return by_arguments(callee, arguments);
}

bool NameReads::by_arguments(const clang::FunctionDecl* callee,
                             llvm::ArrayRef<const clang::Expr*> arguments) const {
  if (unit_.declares(callee)) return false;
  for (unsigned i = 0; i < arguments.size(); ++i) {
    const bool is_named = i < callee->getNumParams();
    if (by_argument(is_named ? callee->getParamDecl(i)->getType() : arguments[i]->getType(), arguments[i]))
      return true;
  }
  return false;
}

bool NameReads::by_argument(clang::QualType parameter, const clang::Expr* argument) const {
  argument = argument->IgnoreParenImpCasts();
  if (parameter->isReferenceType() && !parameter->getPointeeType().isConstQualified())
    return by_store(argument);
  const auto* address = llvm::dyn_cast<clang::UnaryOperator>(argument);
  if (address && address->getOpcode() == clang::UO_AddrOf && parameter->isPointerType())
    return by_store(address->getSubExpr());
  if (argument->getType()->isArrayType()) return by_store(argument);
  return by_pointer(argument->getType());
}

bool NameReads::by_pointer(clang::QualType type) const {
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isPointerType())
    return !type->getPointeeType().isConstQualified() && by_store_to_any(type->getPointeeType());
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  const auto* made = llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(record);
  if (!made) return false;
  const bool leads = record->getName().contains("iterator") || record->getName() == "reference_wrapper";
  if (record->getName().contains("const_iterator")) return false;
  return llvm::any_of(made->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& one) {
    if (one.getKind() != clang::TemplateArgument::Type) return false;
    const clang::QualType inner = one.getAsType();
    if (inner->isPointerType()) return by_pointer(inner);
    return leads && !inner.isConstQualified() && (by_store_to_any(inner) || by_pointer(inner));
  });
}

bool NameReads::by_store(const clang::Expr* stored) const {
  const clang::QualType type = stored->getType();
  if (type.isConstQualified()) return false;
  const clang::ValueDecl* root = root_of(stored);
  const bool is_owned = !root && is_owned_element(stored);
  return moves_object(type) || llvm::any_of(reads_, [&](const Read& read) {
           if (!holds(unit_, type, read.type)) return false;
           if (!read.decl || plain(unit_, type) != read.type) return true;
           return root ? root == read.decl : !is_owned && read.exposed;
         });
}

bool NameReads::by_store_to_any(clang::QualType type) const {
  return moves_object(type) || llvm::any_of(reads_, [&](const Read& read) {
           return read.exposed && holds(unit_, type, read.type);
         });
}

/// A container or an owner of what is led to.
bool NameReads::moves_object(clang::QualType container) const {
  return llvm::any_of(led_to_, [&](clang::QualType type) {
    return plain(unit_, container) != type && holds(unit_, container, type);
  });
}

/// By a pointer to a base class, too.
bool NameReads::is_led_to(clang::QualType type) const {
  type = plain(unit_, type);
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return llvm::any_of(led_to_, [&](clang::QualType led) {
    const clang::CXXRecordDecl* other = led->getAsCXXRecordDecl();
    const bool known = record && other && record->hasDefinition() && other->hasDefinition();
    return type == led || (known && (record->isDerivedFrom(other) || other->isDerivedFrom(record)));
  });
}

}  // namespace tzc::rewriter
