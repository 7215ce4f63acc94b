// SPDX-License-Identifier: BSD-3-Clause
#include <clang/AST/ParentMapContext.h>
#include <clang/Index/USRGeneration.h>

#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

Key place_key(Unit& unit, clang::SourceLocation location, const char* suffix = "") {
  const Place where = unit.source.where(location);
  return where.file + ":" + std::to_string(where.begin) + suffix;
}

bool is_lambda(const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  return method && method->getParent()->isLambda();
}

Key function_key(Unit& unit, const clang::FunctionDecl* function) {
  const clang::FunctionDecl* pattern = pattern_of(function);
  if (is_lambda(pattern)) return place_key(unit, pattern->getLocation(), "#lambda");
  return usr_of(pattern);
}

Key key_of(Unit& unit, const clang::ValueDecl* decl) {
  if (const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(decl)) {
    const auto* function = llvm::dyn_cast<clang::FunctionDecl>(parameter->getDeclContext());
    if (!function) return place_key(unit, decl->getLocation());
    return function_key(unit, function) + "#p" + std::to_string(parameter->getFunctionScopeIndex());
  }
  const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
  if (variable && variable->hasExternalFormalLinkage() && !variable->isTemplated()) return usr_of(decl);
  return place_key(unit, decl->getLocation());
}

Home home_of(const clang::ValueDecl* decl) {
  if (llvm::isa<clang::ParmVarDecl>(decl)) return Home::parameter;
  if (llvm::isa<clang::FieldDecl>(decl)) return Home::member;
  const auto* variable = llvm::cast<clang::VarDecl>(decl);
  if (variable->isStaticDataMember()) return Home::member;
  return variable->isLocalVarDecl() ? Home::local : Home::global;
}

Entity& entity_at(Unit& unit, const Key& key, const Carried& carried, Home home, const std::string& name,
                  clang::SourceLocation where) {
  auto [position, is_new] = unit.facts.entities.emplace(key, Entity{});
  Entity& entity = position->second;
  if (is_new) {
    entity.key = key;
    entity.carrier = carried.carrier;
    entity.ported = carried.ported;
    if (carried.rename) entity.ported_class = carried.rename->to;
    if (carried.rename) entity.ported_header = carried.rename->header;
    entity.home = home;
    entity.name = name;
    entity.where = location_of(unit.source.where(where));
  }
  const bool accessor = carried.rename && carried.rename->role == ClassRename::Role::accessor;
  if (is_new && accessor) unit.facts.data_uses.push_back({key, entity.where, true});
  if (entity.type.empty() && carried.message) entity.type = carried.message->name;
  return entity;
}

bool is_exported(Unit& unit, clang::SourceLocation location) {
  const std::string& file = unit.source.file_of(location);
  return llvm::any_of(unit.exported_dirs,
                      [&](const std::string& dir) { return file.rfind(dir + "/", 0) == 0; });
}

void add(Entity& entity, const Obstacle& obstacle) {
  for (const Obstacle& known : entity.obstacles)
    if (known.code == obstacle.code && known.reason == obstacle.reason) return;
  entity.obstacles.push_back(obstacle);
}

/// Signatures that others rely on: overrides of foreign virtuals, and what exported headers declare.
void check_signature(Unit& unit, const clang::FunctionDecl* function, Entity& entity) {
  const Location where = location_of(unit.source.where(function->getLocation()));
  if (const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function))
    for (const clang::CXXMethodDecl* base : method->overridden_methods())
      if (!unit.source.in_package(base->getLocation()))
        add(entity, {codes::TZC1005,
                     "'" + function->getNameAsString() + "' overrides a function of another package", where});
  const clang::FunctionDecl* first = function->getFirstDecl();
  if (entity.carrier == Carrier::message && first->getAccess() != clang::AS_private &&
      is_exported(unit, first->getLocation()))
    add(entity,
        {codes::TZC1005,
         "'" + function->getNameAsString() + "' is declared in a header that other packages may include",
         where});
}

/// A twin exists for every message that stands alone and whose package has TZC headers; parts of services
/// have none.
void check_type(const Unit& unit, const Carried& carried, Entity& entity) {
  if (carried.message && !carried.message->service && !has_twin(unit, carried.message->name))
    add(entity, {codes::TZC4004, "'" + carried.message->name + "' has no TZC header", entity.where});
  if (carried.message && carried.message->service)
    add(entity, {codes::TZC1002, "it is part of a service", entity.where});
}

void connect_overrides(Unit& unit, const clang::FunctionDecl* function, const Key& key, int parameter) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (!method) return;
  for (const clang::CXXMethodDecl* base : method->overridden_methods()) {
    if (!unit.source.in_package(base->getLocation())) continue;
    const Key other =
        parameter < 0 ? declare_result(unit, base) : declare(unit, base->getParamDecl(parameter));
    if (!other.empty()) add_flow(unit, key, other, function->getLocation(), "overrides a function");
  }
}

void declare_parameter(Unit& unit, const clang::ParmVarDecl* parameter, const Key& key, Entity& entity) {
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(parameter->getDeclContext());
  if (!function) return;
  check_signature(unit, function, entity);
  connect_overrides(unit, function, key, static_cast<int>(parameter->getFunctionScopeIndex()));
}

void check_member(Unit& unit, const clang::FieldDecl* field, Entity& entity) {
  entity.record = usr_of(field->getParent());
  if (entity.carrier == Carrier::message && field->getAccess() != clang::AS_private &&
      is_exported(unit, field->getLocation()))
    add(entity, {codes::TZC1005,
                 "the member '" + entity.name + "' is part of a header that other packages may include",
                 entity.where});
}

}  // namespace

std::string usr_of(const clang::Decl* decl) {
  llvm::SmallString<128> usr;
  clang::index::generateUSRForDecl(decl, usr);
  return usr.str().str();
}

const clang::FunctionDecl* pattern_of(const clang::FunctionDecl* function) {
  const clang::FunctionDecl* pattern = function->getTemplateInstantiationPattern();
  return (pattern ? pattern : function)->getCanonicalDecl();
}

const clang::FunctionDecl* function_around(Unit& unit, const clang::Stmt& stmt) {
  clang::DynTypedNode node = clang::DynTypedNode::create(stmt);
  for (;;) {
    const auto parents = unit.ast().getParents(node);
    if (parents.empty()) return nullptr;
    node = parents[0];
    if (const auto* function = node.get<clang::FunctionDecl>()) return function;
    if (const auto* lambda = node.get<clang::LambdaExpr>()) return lambda->getCallOperator();
  }
}

std::string record_usr_of(const clang::FunctionDecl* function) {
  const clang::DeclContext* context = function;
  while (context && !context->isTranslationUnit()) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(context);
    if (method && !method->getParent()->isLambda())
      return method->isStatic() ? "" : usr_of(method->getParent());
    context = context->getParent();
  }
  return "";
}

bool is_package_function(Unit& unit, const clang::FunctionDecl* function) {
  return function && unit.source.in_package(pattern_of(function)->getLocation());
}

Key declare(Unit& unit, const clang::ValueDecl* decl) {
  if (!llvm::isa<clang::VarDecl, clang::FieldDecl>(decl) || !unit.source.in_package(decl->getLocation()))
    return {};
  const std::optional<Carried> carried = carried_by(decl->getType(), unit.rules);
  if (!carried) return {};
  const Key key = key_of(unit, decl);
  Entity& entity =
      entity_at(unit, key, *carried, home_of(decl), decl->getNameAsString(), decl->getLocation());
  check_type(unit, *carried, entity);
  const clang::CXXRecordDecl* record = decl->getType().getNonReferenceType()->getAsCXXRecordDecl();
  entity.plain = record && unit.rules.find_class_or_ported(qualified_name_of(record)) != nullptr;
  for (const clang::Decl* redeclaration : decl->redecls()) {
    const auto* written = llvm::cast<clang::DeclaratorDecl>(redeclaration);
    if (written->getTypeSourceInfo()) retype(unit, written->getTypeSourceInfo()->getTypeLoc(), entity);
  }
  if (const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(decl))
    declare_parameter(unit, parameter, key, entity);
  if (const auto* field = llvm::dyn_cast<clang::FieldDecl>(decl)) check_member(unit, field, entity);
  return key;
}

Key declare_result(Unit& unit, const clang::FunctionDecl* function) {
  const std::optional<Carried> carried = carried_by(function->getReturnType(), unit.rules);
  if (!carried || llvm::isa<clang::CXXConstructorDecl>(function)) return {};
  const Key key = function_key(unit, function) + "#r";
  Entity& entity =
      entity_at(unit, key, *carried, Home::result, function->getNameAsString(), function->getLocation());
  check_type(unit, *carried, entity);
  for (const clang::FunctionDecl* redeclaration : function->redecls())
    if (redeclaration->getTypeSourceInfo())
      if (const auto type = redeclaration->getFunctionTypeLoc()) retype(unit, type.getReturnLoc(), entity);
  check_signature(unit, function, entity);
  connect_overrides(unit, function, key, -1);
  return key;
}

Key declare_temporary(Unit& unit, const clang::Expr* expr) {
  const std::optional<Carried> carried = carried_by(expr->getType(), unit.rules);
  if (!carried) return {};
  const Key key = place_key(unit, expr->getBeginLoc(), "#") + expr->getStmtClassName();
  Entity& entity = entity_at(unit, key, *carried, Home::temporary, unit.source.text(expr->getSourceRange()),
                             expr->getBeginLoc());
  check_type(unit, *carried, entity);
  return key;
}

void add_flow(Unit& unit, const Key& from, const Key& to, clang::SourceLocation where,
              const std::string& what) {
  if (from.empty() || to.empty() || from == to) return;
  unit.facts.flows.push_back({from, to, location_of(unit.source.where(where)), what});
}

void add_obstacle(Unit& unit, const Key& key, const char* code, const std::string& reason,
                  clang::SourceLocation where) {
  const auto entity = unit.facts.entities.find(key);
  if (entity != unit.facts.entities.end())
    add(entity->second, {code, reason, location_of(unit.source.where(where))});
}

}  // namespace tzc::rewriter
