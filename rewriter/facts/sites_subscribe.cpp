// SPDX-License-Identifier: BSD-3-Clause
#include <clang/AST/ParentMapContext.h>

#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

/// What a callback's parameter says: which message, and whether the callback may write to it.
struct Parameter {
  std::optional<MessageType> message;
  bool writes = false;
};

const clang::ClassTemplateSpecializationDecl* template_of(clang::QualType type) {
  return llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(
      type.getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl());
}

Parameter parameter_of(clang::QualType type) {
  const bool by_value = !type->isReferenceType();
  const clang::QualType bare = type.getNonReferenceType();
  if (const auto message = message_of(bare)) return {message, by_value || !bare.isConstQualified()};
  const clang::QualType pointee = pointee_of(bare);
  if (!pointee.isNull()) return {message_of(pointee), !pointee.isConstQualified()};
  const auto* event = template_of(bare);
  if (!event || event->getName() != "MessageEvent") return {};
  const clang::QualType inner = event->getTemplateArgs()[0].getAsType();
  return {message_of(inner), !inner.isConstQualified()};
}

/// The message parameters of a function type, in the first of them that has one.
Parameter parameter_in(clang::QualType type) {
  if (type.isNull()) return {};
  type = type.getNonReferenceType();
  if (const auto* member = type->getAs<clang::MemberPointerType>()) type = member->getPointeeType();
  if (type->isFunctionPointerType()) type = type->getPointeeType();
  const auto* function = type->getAs<clang::FunctionProtoType>();
  if (!function) return {};
  Parameter found;
  for (const clang::QualType parameter : function->param_types()) {
    const Parameter one = parameter_of(parameter);
    if (one.message && !found.message) found = one;
    if (one.message && one.message->name == found.message->name) found.writes = found.writes || one.writes;
  }
  return found;
}

Parameter parameter_of_arguments(const clang::CallExpr* call) {
  for (const clang::Expr* argument : call->arguments()) {
    const Parameter found = parameter_in(argument->IgnoreParenImpCasts()->getType());
    if (found.message) return found;
  }
  for (const clang::Expr* argument : call->arguments()) {
    const Parameter found = parameter_in(argument->getType());
    if (found.message) return found;
  }
  const clang::FunctionDecl* callee = call->getDirectCallee();
  const clang::TemplateArgumentList* arguments = callee ? callee->getTemplateSpecializationArgs() : nullptr;
  if (!arguments) return {};
  // subscribe<M>(topic, n, function) or subscribe<M, C>(...): C is what the callback takes.
  Parameter found;
  for (const clang::TemplateArgument& argument : arguments->asArray()) {
    if (argument.getKind() != clang::TemplateArgument::Type) continue;
    const clang::QualType type = argument.getAsType();
    const bool is_message = message_of(type).has_value() && !type->isReferenceType();
    const Parameter one = is_message ? Parameter{message_of(type), false} : parameter_of(type);
    if (one.message) found = one;
  }
  return found;
}

void note_callbacks(Unit& unit, const clang::Stmt* stmt, Subscribe& site) {
  if (!stmt) return;
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(reference->getDecl()))
      for (const clang::ParmVarDecl* parameter : function->parameters())
        if (const Key key = declare(unit, parameter); !key.empty()) site.callbacks.push_back(key);
  for (const clang::Stmt* child : stmt->children()) note_callbacks(unit, child, site);
}

std::string id_of(const Subscribe& site) {
  return site.where.file + ":" + std::to_string(site.where.begin) + "<" + site.type;
}

void describe(const Parameter& parameter, Subscribe& site) {
  if (!parameter.message) return;
  site.type = parameter.message->name;
  site.heavy = parameter.message->has_data;
  site.writes = parameter.writes;
}

bool is_image_callback(const MethodCall& rule) {
  return rule.role == MethodCall::Role::subscribe_transport;
}

std::optional<MessageType> filter_message(const clang::CXXRecordDecl* record) {
  const auto* templated = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  if (!templated || templated->getTemplateArgs().size() == 0) return {};
  return message_of(templated->getTemplateArgs()[0].getAsType());
}

/// A filter that subscribes: constructed with a topic, or told to.
void add_filter_site(Unit& unit, const clang::Expr* expr, const clang::CXXRecordDecl* record,
                     llvm::ArrayRef<const clang::Expr*> arguments, const Key& filter) {
  Subscribe site;
  site.where = unit.source.where(expr->getExprLoc());
  site.function = function_name_around(unit, *expr);
  site.type = "sensor_msgs/Image";
  site.filter = filter;
  const ClassRename* rename = unit.rules.find_class_or_ported(qualified_name_of(record));
  if (rename) site.rule = rename->rule;
  site.ported = unit.rules.find_ported_class(qualified_name_of(record)) != nullptr;
  if (const auto message = filter_message(record)) {
    site.type = message->name;
    site.heavy = message->has_data;
  }
  for (const clang::Expr* argument : arguments)
    if (!site.topic && !argument->getType()->isArithmeticType()) site.topic = constant_string(argument);
  const clang::FunctionDecl* function = function_around(unit, *expr);
  site.scope = function ? record_usr_of(function) : "";
  unit.facts.subscribes.emplace(id_of(site), site);
}

Key filter_key(const Sources& sources) {
  return sources.keys.empty() ? Key() : sources.keys[0];
}

}  // namespace

void collect_subscribe(Unit& unit, const clang::CXXMemberCallExpr* call, const MethodCall& rule) {
  Subscribe site;
  site.where = unit.source.where(call->getExprLoc());
  site.function = function_name_around(unit, *call);
  site.rule = rule.rule;
  Parameter parameter = parameter_of_arguments(call);
  std::string written = written_template_arguments(unit, call);
  if (!parameter.message && written_arguments(call) == 1)
    if (const auto type = options_message(unit, call->getArg(0))) {
      parameter.message = message_of(*type);
      written = stock_name(parameter.message->name);
    }
  if (is_image_callback(rule)) site.type = "sensor_msgs/Image";
  describe(parameter, site);
  note_callbacks(unit, call, site);
  const Location here = location_of(site.where);
  if (site.type.empty())
    site.obstacles.push_back({codes::TZC2006, "no message type is to be seen in this call", here});
  if (written_arguments(call) > 0) site.topic = constant_string(call->getArg(0));
  site.changes = receiver_first(unit, call, rule.to + (written.empty() ? "" : "<" + written + ">"), rule.rule,
                                rule.header);
  if (site.changes.empty())
    site.obstacles.push_back({codes::TZC2003, "the subscribe call comes from a macro", here});
  unit.facts.subscribes.emplace(id_of(site), site);
}

void collect_ported_subscribe(Unit& unit, const clang::CallExpr* call, const MethodCall& rule) {
  Subscribe site;
  site.ported = true;
  site.where = unit.source.where(call->getExprLoc());
  site.function = function_name_around(unit, *call);
  site.rule = rule.rule;
  if (is_image_callback(rule)) site.type = "sensor_msgs/Image";
  describe(parameter_of_arguments(call), site);
  note_callbacks(unit, call, site);
  if (written_arguments(call) > 1) site.topic = constant_string(call->getArg(1));
  unit.facts.subscribes.emplace(id_of(site), site);
}

void collect_filter(Unit& unit, const clang::CXXMemberCallExpr* call) {
  if (call->getNumArgs() < 2) return;
  const Receiver receiver = receiver_of(call);
  if (!receiver.expr) return;
  const llvm::ArrayRef<const clang::Expr*> arguments(call->getArgs(), call->getNumArgs());
  add_filter_site(unit, call, call->getRecordDecl(), arguments, filter_key(sources_of(unit, receiver.expr)));
}

void collect_filter(Unit& unit, const clang::CXXConstructExpr* construct, const Key& filter) {
  if (construct->getNumArgs() < 2) return;
  const llvm::ArrayRef<const clang::Expr*> arguments(construct->getArgs(), construct->getNumArgs());
  add_filter_site(unit, construct, construct->getConstructor()->getParent(), arguments, filter);
}

void collect_made_filter(Unit& unit, const clang::CallExpr* call, const clang::CXXRecordDecl* record,
                         const Key& filter) {
  if (call->getNumArgs() < 2) return;
  add_filter_site(unit, call, record, llvm::ArrayRef<const clang::Expr*>(call->getArgs(), call->getNumArgs()),
                  filter);
}

Key filter_of(Unit& unit, const clang::CXXConstructExpr* construct) {
  clang::DynTypedNode node = clang::DynTypedNode::create(*construct);
  for (;;) {
    const auto parents = unit.ast().getParents(node);
    if (parents.empty()) return {};
    node = parents[0];
    if (const auto* variable = node.get<clang::VarDecl>()) return declare(unit, variable);
    if (const auto* created = node.get<clang::CXXNewExpr>()) return declare_temporary(unit, created);
    if (const auto* call = node.get<clang::CallExpr>())
      return makes_object(call) ? declare_temporary(unit, call) : Key();
    if (const auto* constructor = node.get<clang::CXXConstructorDecl>()) {
      for (const clang::CXXCtorInitializer* initializer : constructor->inits())
        if (initializer->getInit()->IgnoreImplicit() == construct && initializer->getMember())
          return declare(unit, initializer->getMember());
      return {};
    }
  }
}

void collect_registered_callback(Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::FunctionDecl* function = function_around(unit, *call);
  if (!function) return;
  for (const clang::Expr* argument : call->arguments())
    note_writing_callback(unit, argument, record_usr_of(function));
}

void note_writing_callback(Unit& unit, const clang::Stmt* stmt, const std::string& scope) {
  if (!stmt) return;
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
    if (const auto* function = llvm::dyn_cast<clang::FunctionDecl>(reference->getDecl()))
      for (const clang::ParmVarDecl* parameter : function->parameters()) {
        const Parameter one = parameter_of(parameter->getType());
        if (one.message && one.writes)
          unit.facts.writing_filter_scopes.insert(scope + " " + one.message->name);
      }
  for (const clang::Stmt* child : stmt->children()) note_writing_callback(unit, child, scope);
}

}  // namespace tzc::rewriter
