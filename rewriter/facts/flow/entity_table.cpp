// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/entity_table.h"

#include "facts/flow/declarators.h"
#include "facts/flow/exported_uses.h"
#include "facts/flow/spelling.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"
#include "parse/versions.h"

namespace tzc::rewriter {
namespace {

std::string place_id(const Unit& unit, clang::SourceLocation location, const char* suffix = "") {
  const Place where = unit.source.where(location);
  return where.file + ":" + std::to_string(where.begin) + suffix;
}

std::string function_id(const Unit& unit, const clang::FunctionDecl* function) {
  const clang::FunctionDecl* pattern = pattern_of(function);
  if (is_lambda(pattern)) return place_id(unit, pattern->getLocation(), "#lambda");
  return usr_of(pattern);
}

EntityId id_of(const Unit& unit, const clang::ValueDecl* decl) {
  if (const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(decl)) {
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(parameter->getDeclContext());
    if (!function) return EntityId(place_id(unit, decl->getLocation()));
    return EntityId(function_id(unit, function) + "#p" + std::to_string(parameter->getFunctionScopeIndex()));
  }
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  if (variable && variable->hasExternalFormalLinkage() && !variable->isTemplated())
    return EntityId(usr_of(decl));
  return EntityId(place_id(unit, decl->getLocation()));
}

Storage storage_of(const clang::ValueDecl* decl) {
  if (llvm::isa<clang::ParmVarDecl>(decl)) return Storage::parameter;
  if (llvm::isa<clang::FieldDecl>(decl)) return Storage::member;
  const auto* variable = llvm::cast<clang::VarDecl>(decl);
  if (variable->isStaticDataMember()) return Storage::member;
  if (variable->isStaticLocal()) return Storage::static_local;
  return variable->isLocalVarDecl() && !variable->hasExternalStorage() ? Storage::local : Storage::global;
}

void add(Entity& entity, const Obstacle& obstacle) {
  for (const Obstacle& known : entity.obstacles)
    if (known.code == obstacle.code && known.reason == obstacle.reason) return;
  entity.obstacles.push_back(obstacle);
}

void note_friends(EntityFacts& facts, const EntityId& id, std::set<std::string> friends) {
  if (!friends.empty()) facts.friends[id] = std::move(friends);
}

/// Where a declarator that shares its type with others can part from the one in front of it.
std::optional<Cut> cut_before(const Unit& unit, const clang::ValueDecl* decl, const Entity& entity) {
  const auto* declarator = llvm::dyn_cast<clang::DeclaratorDecl>(decl);
  if (!declarator || entity.ported || entity.changes.empty()) return {};
  const std::optional<SharedDeclaration> shared = shared_declaration(unit, declarator);
  if (!shared) return {};
  const std::string words = unit.source.text(shared->type);
  const std::string ported = with_changes(shared->type, words, entity.changes);
  return Cut{id_of(unit, shared->left), shared->type, shared->at, shared->before + words + shared->after,
             shared->before + ported + shared->after};
}

}  // namespace

Entity& EntityTable::entity_at(const EntityId& id, const Carried& carried, Description describe) {
  auto [position, is_new] = facts_.entities.emplace(id, Entity{});
  Entity& entity = position->second;
  if (is_new) {
    entity.id = id;
    describe(entity);
    entity.role = carried.role;
    entity.ported = carried.ported;
    if (carried.rename) entity.ported_as = {carried.rename->to, carried.rename->header};
    const bool accessor = carried.rename && carried.rename->role == ClassRename::Role::accessor;
    if (accessor) facts_.data_uses.push_back({id, entity.where, {}, false});
  }
  if (entity.type.empty() && carried.message) entity.type = carried.message->name;
  return entity;
}

/// Signatures that other code relies on: overrides of foreign virtual functions, and declarations in exported
/// headers.
namespace {

/// Closures have theirs where they stand.
bool needs_body(const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return !is_pure_virtual(function) && !(method && method->getParent()->isLambda());
}

}  // namespace

void EntityTable::check_signature(Entity& entity, const clang::FunctionDecl* function) {
  const Location where = unit_.location(function->getLocation());
  const std::string name = "'" + function->getNameAsString() + "'";
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method)
    for (const clang::CXXMethodDecl* base : method->overridden_methods())
      if (!unit_.source.in_package(base->getLocation()))
        add(entity, {codes::TZC1005, name + " overrides a function of another package", where});
  if (has_symbol_without_types(function))
    add(entity, {codes::TZC1005, "the symbol of " + name + " does not tell its types", where});
  if (may_have_another_body(function))
    add(entity, {codes::TZC1005, name + " may have another body where it is linked", where});
  const clang::FunctionDecl* first = function->getFirstDecl();
  if (first->getAccess() == clang::AS_private && !(method && method->isVirtual()))
    note_friends(facts_, entity.id, friends_of(unit_, first));
  if (unit_.exports(function))
    add(entity,
        {codes::TZC1005, name + " is declared in a header that other packages may include", where, true});
}

/// A twin exists for every message that stands alone and whose package has TZC headers; parts of services
/// have none.
void EntityTable::check_type(Entity& entity, const Carried& carried) const {
  if (carried.message && !carried.message->service && !unit_.has_twin(carried.message->name))
    add(entity, {codes::TZC4004, "'" + carried.message->name + "' has no TZC header", entity.where});
  if (carried.message && carried.message->service)
    add(entity, {codes::TZC1002, "it is part of a service", entity.where});
}

void EntityTable::connect_overrides(const EntityId& id, const clang::FunctionDecl* function, int parameter) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (!method) return;
  for (const clang::CXXMethodDecl* base : method->overridden_methods()) {
    if (!unit_.source.in_package(base->getLocation())) continue;
    const EntityId other = parameter < 0 ? declare_result(base) : declare(base->getParamDecl(parameter));
    add_flow(id, other, {function->getLocation(), "overrides a function"});
    add_flow(other, id, {function->getLocation(), "is overridden"});
  }
}

/// Members and variables that other packages may name.
void EntityTable::check_exported(Entity& entity, const clang::ValueDecl* decl) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(decl);
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  if (field) entity.member_of.record = usr_of(field->getParent());
  entity.member_of.is_private = field && decl->getAccess() == clang::AS_private;
  const bool lasts = field || (variable->hasGlobalStorage() && !variable->isStaticLocal());
  if (lasts && decl->getAccess() == clang::AS_private)
    note_friends(facts_, entity.id, friends_of(unit_, decl));
  if (variable && has_symbol_without_types(variable))
    add(entity, {codes::TZC1005, "the symbol of '" + entity.name + "' does not tell its type", entity.where});
  const bool is_inner = decl->getAccess() == clang::AS_private && !(field && unit_.layouts_stay);
  if (!lasts || is_inner) return;
  for (const clang::Decl* declaration : decl->redecls())
    if (unit_.exports(declaration->getLocation()))
      add(entity,
          {codes::TZC1005,
           (field ? "the member '" + entity.name + "' is part of" : "'" + entity.name + "' is declared in") +
               std::string(" a header that other packages may include"),
           field ? entity.where : unit_.location(declaration->getLocation()), true});
}

void EntityTable::respell(Entity& entity, clang::TypeLoc written) {
  if (entity.ported) return;
  types_.note(entity.id, written);
  Respelling respelling = rewriter::respell(unit_, written, entity.role);
  for (Change& change : respelling.changes) {
    const bool known = llvm::any_of(entity.changes, [&](const Change& c) {
      return c.where.file == change.where.file && c.where.begin == change.where.begin &&
             c.text == change.text;
    });
    if (!known) entity.changes.push_back(std::move(change));
  }
  for (Obstacle& obstacle : respelling.obstacles) {
    const bool known =
        llvm::any_of(entity.obstacles, [&](const Obstacle& o) { return o.code == obstacle.code; });
    if (!known) entity.obstacles.push_back(std::move(obstacle));
  }
}

namespace {

/// auto& [name, pub]: the member that a name is bound to, or the pair that it is part of.
const clang::ValueDecl* bound_by(const clang::BindingDecl* binding) {
  const auto* member = llvm::dyn_cast_or_null<clang::MemberExpr>(
      binding->getBinding() ? binding->getBinding()->IgnoreParenImpCasts() : nullptr);
  return member ? member->getMemberDecl() : llvm::cast<clang::ValueDecl>(binding->getDecomposedDecl());
}

}  // namespace

EntityId EntityTable::declare(const clang::ValueDecl* decl) {
  if (const auto* binding = llvm::dyn_cast<clang::BindingDecl>(decl))
    return carried_by(decl->getType(), unit_.rules) ? declare(bound_by(binding)) : EntityId();
  if (!llvm::isa<clang::VarDecl, clang::FieldDecl>(decl) || !unit_.source.in_package(decl->getLocation()))
    return {};
  const std::optional<Carried> carried = carried_by(decl->getType(), unit_.rules);
  if (!carried) return {};
  const EntityId id = id_of(unit_, decl);
  Entity& entity = entity_at(id, *carried, [&](Entity& fresh) {
    fresh.storage = storage_of(decl);
    fresh.name = decl->getNameAsString();
    if (fresh.storage == Storage::global) fresh.member_of.scope = namespaces_around(decl);
    fresh.where = unit_.location(decl->getLocation());
  });
  check_type(entity, *carried);
  const clang::CXXRecordDecl* record = decl->getType().getNonReferenceType()->getAsCXXRecordDecl();
  if (record && unit_.rules.find_class_or_ported(qualified_name_of(record)))
    entity.form = Form::itself;
  else if (!decl->getType()->isReferenceType() && holds_messages(decl->getType()))
    entity.form = Form::contained;
  for (const clang::Decl* redeclaration : decl->redecls()) {
    const auto* written = llvm::cast<clang::DeclaratorDecl>(redeclaration);
    if (written->getTypeSourceInfo()) respell(entity, written->getTypeSourceInfo()->getTypeLoc());
  }
  if (facts_.cuts.count(id) == 0)
    if (std::optional<Cut> cut = cut_before(unit_, decl, entity)) facts_.cuts.emplace(id, std::move(*cut));
  check_exported(entity, decl);
  if (!decl->getType()->isReferenceType() && message_of(decl->getType())) {
    facts_.objects.insert(id);
    entity.form = Form::itself;
  }
  const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(decl);
  const auto* function =
      parameter ? llvm::dyn_cast<clang::FunctionDecl>(parameter->getDeclContext()) : nullptr;
  if (!function) return id;
  types_.note(id, parameter);
  if (needs_body(function)) facts_.parameters.emplace(id, usr_of(pattern_of(function)));
  check_signature(entity, function);
  connect_overrides(id, function, static_cast<int>(parameter->getFunctionScopeIndex()));
  return id;
}

EntityId EntityTable::result_id(const clang::FunctionDecl* function) const {
  return EntityId(function_id(unit_, function) + "#r");
}

EntityId EntityTable::declare_result(const clang::FunctionDecl* function) {
  const std::optional<Carried> carried = carried_by(function->getReturnType(), unit_.rules);
  if (!carried || llvm::isa<clang::CXXConstructorDecl>(function)) return {};
  const EntityId id = result_id(function);
  Entity& entity = entity_at(id, *carried, [&](Entity& fresh) {
    fresh.storage = Storage::result;
    fresh.name = function->getNameAsString();
    fresh.where = unit_.location(function->getLocation());
  });
  check_type(entity, *carried);
  for (const clang::FunctionDecl* redeclaration : function->redecls())
    if (redeclaration->getTypeSourceInfo())
      if (const auto type = redeclaration->getFunctionTypeLoc()) respell(entity, type.getReturnLoc());
  check_signature(entity, function);
  connect_overrides(id, function, -1);
  return id;
}

EntityId EntityTable::declare_temporary(const clang::Expr* expr) {
  const std::optional<Carried> carried = carried_by(expr->getType(), unit_.rules);
  if (!carried) return {};
  const EntityId id(place_id(unit_, expr->getBeginLoc(), "#") + expr->getStmtClassName());
  Entity& entity = entity_at(id, *carried, [&](Entity& fresh) {
    fresh.storage = Storage::temporary;
    fresh.name = unit_.text(expr);
    fresh.where = unit_.location(expr->getBeginLoc());
  });
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  if (llvm::isa<clang::CXXNewExpr>(expr) || (call && makes_object(call)) ||
      (expr->isPRValue() && message_of(expr->getType())))
    facts_.objects.insert(id);
  check_type(entity, *carried);
  return id;
}

void EntityTable::retype(const EntityId& id, clang::TypeLoc written) {
  const auto entity = facts_.entities.find(id);
  if (entity != facts_.entities.end()) respell(entity->second, written);
}

void EntityTable::add_flow(const EntityId& from, const EntityId& to, const Passage& passage) {
  if (from.empty() || to.empty() || from == to) return;
  facts_.flows.push_back(
      {from, to, unit_.location(passage.where), passage.what, passage.copies, passage.as_stock});
}

void EntityTable::add_obstacle(const EntityId& id, const Obstacle& obstacle) {
  const auto entity = facts_.entities.find(id);
  if (entity != facts_.entities.end()) add(entity->second, obstacle);
}

void EntityTable::add_obstacle(const EntityId& id, const char* code, const std::string& reason,
                               clang::SourceLocation where) {
  add_obstacle(id, {code, reason, unit_.location(where)});
}

void EntityTable::add_use(const EntityId& id, Change change) {
  facts_.uses.push_back({id, std::move(change)});
}

void EntityTable::add_data_use(const EntityId& id, clang::SourceLocation where, const ArrayGrowth& growth) {
  facts_.data_uses.push_back({id, unit_.location(where), growth.most_bytes, growth.appends});
}

EntityFacts EntityTable::take() {
  types_.tie(facts_);
  return std::move(facts_);
}

const Entity& EntityTable::operator[](const EntityId& id) const {
  static const Entity unknown;
  const auto entity = facts_.entities.find(id);
  return entity == facts_.entities.end() ? unknown : entity->second;
}

}  // namespace tzc::rewriter
