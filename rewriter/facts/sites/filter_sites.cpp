// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/filter_sites.h"

#include "facts/sites/argument_order.h"
#include "facts/sites/asked_transport.h"
#include "facts/sites/callback_functions.h"
#include "facts/sites/callback_parameter.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/call_place.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// A filter that names its message, as message_filters::Subscriber does.
void describe_type(Subscribe& site, clang::QualType type, const clang::PrintingPolicy& policy) {
  const CallbackParameter parameter = callback_parameter_of(type);
  site.type = type.getAsString(policy);
  site.converts = parameter.converts;
  if (parameter.message)
    set_message(site, *parameter.message);
  else
    site.obstacles.push_back({codes::TZC2006, "'" + site.type + "' is no message", location_of(site.where)});
}

template <class Call>
llvm::ArrayRef<const clang::Expr*> arguments_of(const Call* call) {
  return {call->getArgs(), call->getNumArgs()};
}

/// What a new element is made from; as the value of a map: try_emplace(key, ...),
/// emplace(std::piecewise_construct, key, std::forward_as_tuple(...)).
llvm::ArrayRef<const clang::Expr*> emplaced_from(const clang::CXXMemberCallExpr* call, bool is_value) {
  const std::string name = call->getMethodDecl()->getNameAsString();
  const llvm::ArrayRef<const clang::Expr*> arguments = arguments_of(call);
  if (name == "try_emplace")
    return arguments.drop_front(is_value && !arguments.empty() ? 1 : arguments.size());
  if (name.rfind("emplace", 0) != 0 || arguments.empty()) return {};
  if (!is_value) return arguments;
  const auto* tuple = llvm::dyn_cast<clang::CallExpr>(arguments.back()->IgnoreImplicit());
  const clang::FunctionDecl* made_by = tuple ? tuple->getDirectCallee() : nullptr;
  const bool is_tuple = made_by && qualified_name_of(made_by) == "std::forward_as_tuple";
  return is_tuple ? arguments_of(tuple) : llvm::ArrayRef<const clang::Expr*>();
}

}  // namespace

Subscribe FilterCollector::site_of(const Construction& construction, const EntityId& filter) const {
  Subscribe site;
  set_place(site, unit_, construction.expr);
  site.type = "sensor_msgs/Image";
  site.filter = filter;
  const std::string name = qualified_name_of(construction.record);
  const ClassRename* rename = unit_.rules.find_class_or_ported(name);
  if (rename) site.rule = rename->rule;
  site.ported = construction.is_attached || unit_.rules.find_ported_class(name) != nullptr;
  const auto* templated = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(construction.record);
  if (const clang::QualType type = first_argument(templated); !type.isNull())
    describe_type(site, type, unit_.ast().getPrintingPolicy());
  for (const clang::Expr* argument : construction.arguments)
    if (!site.topic && !argument->getType()->isArithmeticType()) site.topic = constant_string(argument);
  site.asked_transport = asked_transport(construction.arguments);
  site.scope = scope_of(construction.expr);
  site.changes_if_kept = construction.changes_if_kept;
  if (site.converts && !site.changes_if_kept.empty()) site.changes_if_kept[0].headers.push_back("tzc/pcl.h");
  // A library's own, or a base: whatever others register with it.
  site.is_unknown = filter.empty();
  if (filter.empty() && site.changes_if_kept.empty() && !construction.is_attached)
    site.obstacles.push_back(
        {codes::TZC2009, "what holds the filter cannot be given another type", location_of(site.where)});
  return site;
}

/// The class around an expression, also when a member begins with it.
std::string FilterCollector::scope_of(const clang::Expr* expr) const {
  if (const clang::FunctionDecl* function = enclosing_function(unit_.ast(), *expr))
    return record_usr_of(function);
  for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *expr))
    if (const auto* field = node.get<clang::FieldDecl>()) return usr_of(field->getParent());
  return "";
}

EntityId FilterCollector::filter_of(const clang::Expr* object) {
  const FlowSources sources = flow_.sources_of(object, EntityRole::filter);
  return sources.entities.empty() ? EntityId() : sources.entities[0];
}

std::optional<Subscribe> FilterCollector::of_call(const clang::CXXMemberCallExpr* call) {
  if (call->getNumArgs() < 2) return {};
  const Receiver receiver = receiver_of(call);
  if (!receiver.expr) return {};
  return site_of({call, call->getMethodDecl()->getParent(), arguments_of(call), false, changes_if_kept(call)},
                 filter_of(receiver.expr));
}

/// The edits that have the call attach shared memory to its topic; empty: they cannot be made.
std::vector<Change> FilterCollector::changes_if_kept(const clang::CXXMemberCallExpr* call) const {
  const MethodCall* rule =
      unit_.rules.find_filter_call(qualified_name_of(call->getMethodDecl()->getParent()));
  const auto* callee = llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
  // Subscriber<M>::subscribe(...) does not call what overrides it, perhaps the function around it.
  if (!rule || !callee || callee->hasQualifier()) return {};
  // Other instances may have another class there.
  if (is_instance(enclosing_function(unit_.ast(), *call)) || order_matters(unit_, call)) return {};
  return receiver_first(unit_, call, {rule->to, rule->rule, rule->header});
}

std::optional<Subscribe> FilterCollector::of_attached(const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getNumArgs() >= 3 ? call->getDirectCallee() : nullptr;
  if (!function || !unit_.rules.is_filter_call(qualified_name_of(function))) return {};
  const clang::Expr* object = call->getArg(0);
  const clang::CXXRecordDecl* record = object->getType()->getAsCXXRecordDecl();
  if (!is_filter(record)) return {};
  const EntityId filter = filter_of(object);
  if (!filter.empty()) subscribe_by_method(filter, call);
  return site_of({call, record, arguments_of(call).drop_front(), true}, filter);
}

/// tzc::message_filters::subscribe(filter, nh, "topic", 1) -> filter.subscribe(nh, "topic", 1), when the filter gets TZC's class.
void FilterCollector::subscribe_by_method(const EntityId& filter, const clang::CallExpr* call) {
  const std::vector<Change> changes = receiver_back(unit_, call, {"subscribe", "kept-filter", nullptr});
  for (const Change& change : changes) entities_.add_use(filter, change);
  if (changes.empty())
    entities_.add_obstacle(filter, codes::TZC1006, "the call comes from a macro", call->getBeginLoc());
}

std::optional<Subscribe> FilterCollector::of_construction(const clang::CXXConstructExpr* construct) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  // A class of the package that has taken over the constructors of its base.
  const clang::CXXConstructorDecl* inherited =
      is_filter(constructor->getParent()) ? nullptr : constructor->getInheritedConstructor().getConstructor();
  if (inherited) constructor = inherited;
  if (!is_filter(constructor->getParent())) return {};
  const EntityId filter = inherited ? EntityId() : constructed(construct);
  if (construct->getNumArgs() < 2) return {};
  return site_of({construct, constructor->getParent(), arguments_of(construct)}, filter);
}

std::optional<Subscribe> FilterCollector::of_made(const clang::CallExpr* call, const EntityId& filter) {
  const clang::CXXRecordDecl* record = class_that_is_made(call);
  if (call->getNumArgs() < 2 || !is_filter(record)) return {};
  return site_of({call, record, arguments_of(call)}, filter);
}

bool FilterCollector::is_filter(const clang::CXXRecordDecl* record) const {
  const ClassRename* rename = record ? unit_.rules.find_class_or_ported(qualified_name_of(record)) : nullptr;
  return rename && rename->role == ClassRename::Role::filter;
}

std::optional<Subscribe> FilterCollector::of_emplaced(const clang::CXXMemberCallExpr* call) {
  const auto* container =
      llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(call->getMethodDecl()->getParent());
  if (!container) return {};
  for (unsigned i = 0; i < 2 && i < container->getTemplateArgs().size(); ++i) {
    const clang::TemplateArgument& held = container->getTemplateArgs()[i];
    if (held.getKind() != clang::TemplateArgument::Type) continue;
    const clang::CXXRecordDecl* record = held.getAsType()->getAsCXXRecordDecl();
    const llvm::ArrayRef<const clang::Expr*> arguments = emplaced_from(call, i == 1);
    if (!is_filter(record) || arguments.size() < 2) continue;
    return site_of({call, record, arguments}, filter_of(call->getImplicitObjectArgument()));
  }
  return {};
}

/// The entity that a constructed filter becomes.
EntityId FilterCollector::constructed(const clang::CXXConstructExpr* construct) {
  for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *construct)) {
    if (const auto* variable = node.get<clang::VarDecl>()) return entities_.declare(variable);
    if (const auto* field = node.get<clang::FieldDecl>()) return entities_.declare(field);
    if (const auto* created = node.get<clang::CXXNewExpr>()) return entities_.declare_temporary(created);
    if (const auto* call = node.get<clang::CallExpr>())
      return makes_object(call) ? entities_.declare_temporary(call) : EntityId();
    if (const auto* constructor = node.get<clang::CXXConstructorDecl>()) {
      for (const clang::CXXCtorInitializer* initializer : constructor->inits())
        if (initializer->getInit()->IgnoreImplicit() == construct && initializer->getMember())
          return entities_.declare(initializer->getMember());
      return {};
    }
  }
  return {};
}

void FilterCollector::note_callback(std::map<FilterCallback, FilterCallbackUse>& callbacks,
                                    const clang::FunctionDecl* function, FilterCallback where) const {
  for (const clang::ParmVarDecl* parameter : function->parameters()) {
    const CallbackParameter one = callback_parameter_of(parameter->getType());
    if (!one.message) continue;
    where.type = one.message->name;
    FilterCallbackUse& use = callbacks[where];
    use.writes |= one.writes;
    if (const EntityId id = entities_.declare(parameter); !id.empty()) use.parameters.insert(id);
  }
}

namespace {

/// sync_->registerCallback(...), filter.registerCallback(...): of this object, or of this function. Otherwise it is somebody else's.
bool is_own(const clang::Expr* object) {
  for (;;) {
    object = object->IgnoreParenImpCasts();
    const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(object);
    const auto* deref = llvm::dyn_cast<clang::UnaryOperator>(object);
    if (op && op->getNumArgs() == 1)
      object = op->getArg(0);
    else if (deref)
      object = deref->getSubExpr();
    else
      break;
  }
  if (llvm::isa<clang::CXXThisExpr>(object)) return true;
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(object))
    return llvm::isa<clang::CXXThisExpr>(member->getBase()->IgnoreParenImpCasts());
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(object);
  const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  return variable && !llvm::isa<clang::ParmVarDecl>(variable) && !variable->getType()->isReferenceType() &&
         !variable->getType()->isPointerType();
}

}  // namespace

void FilterCollector::add_callbacks(const clang::CXXMemberCallExpr* call,
                                    std::map<FilterCallback, FilterCallbackUse>& callbacks) const {
  const clang::FunctionDecl* function = enclosing_function(unit_.ast(), *call);
  if (!function) return;
  const clang::Expr* receiver = call->getImplicitObjectArgument();
  FilterCallback where{is_own(receiver) ? record_usr_of(function) : any_class, "", {}};
  const FlowSources filters = flow_.sources_of(receiver);
  if (filters.entities.size() == 1 && !filters.foreign &&
      entities_[filters.entities[0]].role == EntityRole::filter)
    where.filter = filters.entities[0];
  for (const clang::Expr* argument : call->arguments()) {
    for (const clang::FunctionDecl* callback : callback_functions(unit_, argument))
      note_callback(callbacks, callback, where);
    if (calls_unknown_functions(unit_, argument)) callbacks[where].is_unknown = true;
  }
}

}  // namespace tzc::rewriter
