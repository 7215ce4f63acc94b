// SPDX-License-Identifier: BSD-3-Clause
#include "facts/collectors.h"

#include <clang/AST/Attr.h>

#include <map>
#include <set>
#include <string>

#include "facts/content/content_events.h"
#include "facts/content/given_messages.h"
#include "facts/escape/element_uses.h"
#include "facts/escape/escape.h"
#include "facts/escape/shared_mats.h"
#include "facts/escape/threads.h"
#include "facts/flow/call_effects.h"
#include "facts/flow/exported_uses.h"
#include "facts/sites/callback_parameter.h"
#include "facts/sites/element_drafts.h"
#include "facts/sites/factories.h"
#include "facts/sites/library_sites.h"
#include "facts/sites/lock_guarded.h"
#include "facts/sites/publish_sites.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/library_advertise.h"
#include "facts/syntax/lock_names.h"
#include "facts/syntax/window_callbacks.h"
#include "model/codes.h"
#include "parse/versions.h"

namespace tzc::rewriter {
namespace {

PublishEvent call_of(const std::string& function) {
  PublishEvent event;
  event.kind = PublishEvent::Kind::call;
  event.callee = function;
  return event;
}

template <class Site>
void add_site(std::map<SiteId, Site>& sites, std::optional<Site> site) {
  if (site) sites.emplace(site->id(), std::move(*site));
}

/// Instances of a template may give one subscription different callbacks.
void add_site(std::map<SiteId, Subscribe>& sites, std::optional<Subscribe> site) {
  if (!site) return;
  const auto [known, is_new] = sites.emplace(site->id(), *site);
  if (!is_new) known->second.add_callbacks(*site);
}

/// What `of` overrides, `method` overrides.
void note_overrides(const clang::CXXMethodDecl* method, const clang::CXXMethodDecl* of,
                    std::map<std::string, std::set<std::string>>& overrides) {
  for (const clang::CXXMethodDecl* overridden : of->overridden_methods()) {
    overrides[usr_of(pattern_of(overridden))].insert(usr_of(pattern_of(method)));
    note_overrides(method, overridden, overrides);
  }
}

/// Why the program may rely on the size or layout of the type: the memory is its own, or what lies there is not shown. Empty: it
/// does not.
std::string why_not_another_type(const Unit& unit, const clang::Expr* expr) {
  const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(expr);
  if (made && made->getOperatorNew() && made->getOperatorNew()->isReservedGlobalPlacementOperator())
    return "it is made in memory whose size the program has chosen";
  const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expr);
  const clang::Expr* from = cast ? cast->getSubExprAsWritten() : nullptr;
  const bool is_address = cast && !message_of(cast->getType()) && from->getType()->isScalarType();
  return is_address && !is_null(unit, from) && !carried_by(from->getType(), unit.rules)
             ? "it is " + cast_from(from->getType())
             : "";
}

std::string main_file(const Unit& unit) {
  const clang::SourceManager& manager = unit.source.manager();
  return unit.source.file_of(manager.getLocForStartOfFile(manager.getMainFileID()));
}

/// Whether the unit becomes a program of its own: a program has one main(), and may ignore another one in a shared library.
bool makes_program(const Unit& unit, const clang::FunctionDecl* function) {
  const clang::LangOptions& options = unit.ast().getLangOpts();
  const bool is_for_library = options.PICLevel != 0 && !options.PIE;
  return function->isMain() && function->isThisDeclarationADefinition() && !is_for_library;
}

/// Units that do not see that it is weak call it, too.
void note_body(const clang::FunctionDecl* function, Facts& facts) {
  const std::string usr = usr_of(pattern_of(function));
  if (!may_have_another_body(function)) {
    facts.bodies.insert(usr);
    return;
  }
  facts.effects[usr].push_back({});  // what is not known
  facts.locking.insert(usr);
}

/// Leaves out those of templates that have an instance with one for the same message. A template has no constructor yet for
/// `Image out = *in;` where `in` is of any type, and no function for `Image out = get(in);`.
void leave_to_instances(std::vector<AllocationDraft>& drafts) {
  std::set<EntityId> in_instances;
  for (const AllocationDraft& draft : drafts)
    if (!draft.is_of_template) in_instances.insert(draft.site.entity);
  llvm::erase_if(drafts, [&](const AllocationDraft& draft) {
    return draft.is_of_template && in_instances.count(draft.site.entity) != 0;
  });
}

/// Whether a function has to itself what it is given for a parameter of this type.
bool is_own_message(clang::QualType parameter) {
  const CallbackParameter given = callback_parameter_of(parameter);
  return given.message && given.writes;
}

}  // namespace

void Collectors::declaration(const clang::VarDecl* variable) {
  if (!variable->getType()->isDependentType())
    for (AllocationDraft& draft : of_each_element(allocations_.of_declaration(variable)))
      add(std::move(draft));
  const EntityId id = entities_.declare(variable);
  if (!id.empty() && llvm::isa<clang::ParmVarDecl>(variable))
    facts_.add_parameter(id, is_own_message(variable->getType()));
  if (!id.empty() && variable->hasAttr<clang::CleanupAttr>())
    entities_.add_obstacle(id, codes::TZC1001, "a function is given it where its scope ends",
                           variable->getLocation());
  flow_.check_source_of(variable);
}

void Collectors::function(const clang::FunctionDecl* function) {
  if (makes_program(unit_, function)) facts_.programs.insert(main_file(unit_));
  if (!llvm::isa<clang::CXXDestructorDecl>(function)) entities_.declare_result(function);
  if (std::optional<Factory> factory = factory_of(unit_, function))
    facts_.factories.emplace(entities_.result_id(function), std::move(*factory));
}

void Collectors::bases(const clang::CXXRecordDecl* record) {
  for (const clang::CXXBaseSpecifier& base : record->bases())
    if (const clang::CXXRecordDecl* of = base.getType()->getAsCXXRecordDecl())
      facts_.bases[usr_of(record)].insert(usr_of(of));
  for (const clang::CXXMethodDecl* method : record->methods())
    if (!is_pure_virtual(method) && !llvm::isa<clang::CXXDestructorDecl>(method))
      note_overrides(method, method, facts_.overrides);
  facts_.records.insert(usr_of(record));
  hidden_.note(record);
}

void Collectors::name(const clang::Expr* expr, const clang::ValueDecl* decl) {
  const EntityId id = entities_.declare(decl);
  if (id.empty()) return;
  if (is_given_to_users(unit_, expr))
    entities_.add_obstacle(
        id,
        {codes::TZC1005, "a template in a header that other packages may include gives it to what they say",
         unit_.location(expr->getExprLoc()), true});
  if (expr->isTypeDependent()) return;
  const FlowEnd end = flow_.follow(expr, id);
  if (entities_[id].role == EntityRole::publisher && changes_what_others_see(unit_, expr, decl))
    facts_.changing.insert(id);
  const Storage storage = entities_[id].storage;
  const clang::FunctionDecl* around = enclosing_function(unit_.ast(), *expr);
  if (storage == Storage::member && around && end.publish && message_of(expr->getType()))
    parts_.emplace(std::pair(usr_of(around), unit_.text(expr)), std::pair(id, expr));
}

/// An expression that names the type of a new object.
void Collectors::object(const clang::Expr* expr, const clang::TypeSourceInfo* type) {
  if (expr->isTypeDependent() || !unit_.source.in_package(expr->getBeginLoc())) return;
  const EntityId id = entities_.declare_temporary(expr);
  if (id.empty()) return;
  if (type) entities_.retype(id, type->getTypeLoc());
  if (const std::string reason = why_not_another_type(unit_, expr); !reason.empty())
    entities_.add_obstacle(id, entities_.is_message(id) ? codes::TZC1001 : codes::TZC1010, reason,
                           expr->getBeginLoc());
  const FlowEnd end = flow_.follow(expr, id);
  const clang::QualType pointee = pointee_of(expr->getType());
  const bool makes = llvm::isa<clang::CXXNewExpr>(expr) || message_of(expr->getType());
  const auto message = message_of(pointee.isNull() ? expr->getType() : pointee);
  if (makes && message && message->has_data_part) add(allocations_.of_object(expr, id, end));
}

void Collectors::construction(const clang::CXXConstructExpr* construct) {
  if (!unit_.source.in_package(construct->getBeginLoc())) return;
  hidden_.note(construct->getType(), {construct->getArgs(), construct->getNumArgs()});
  note_given_publishers(unit_, flow_, {construct->getType(), {construct->getArgs(), construct->getNumArgs()}},
                        facts_);
  add_site(facts_.advertises, library_advertise(unit_, construct));
  add_site(facts_.subscribes, filters_.of_construction(construct));
}

void Collectors::made_object(const clang::CallExpr* call) {
  const EntityId id = entities_.declare_temporary(call);
  if (id.empty()) return;
  const auto* callee = llvm::dyn_cast<clang::DeclRefExpr>(call->getCallee()->IgnoreParenImpCasts());
  if (callee) retype(entities_, id, callee->template_arguments());
  const FlowEnd end = flow_.follow(call, id);
  const auto message = message_of(pointee_of(call->getType()));
  if (message && message->has_data_part) add(allocations_.of_object(call, id, end));
}

void Collectors::library_call(const clang::CallExpr* call) {
  std::optional<AdvertiseCollector::LibraryCall> advertised = advertises_.of_library_call(call);
  if (!advertised) return;
  const EntityId publisher = advertised->site.publisher;
  add_site(facts_.advertises, std::optional(std::move(advertised->site)));
  flow_.follow(advertised->publisher, publisher);
}

void Collectors::call(const clang::CallExpr* call) {
  if (call->isTypeDependent() || !unit_.source.in_package(call->getBeginLoc())) return;
  add_site(facts_.subscribes, library_subscribe(unit_, call));
  add_site(facts_.advertises, library_advertise_made(unit_, call));
  add(factory_call(unit_, entities_, call));
  for (const std::string& callback : callbacks_given_to_windows(call)) {
    facts_.effects[window_callbacks].push_back(call_of(callback));
    if (callback.empty()) facts_.locking.insert(window_callbacks);
  }
  add_site(facts_.subscribes,
           filters_.of_made(call, makes_object(call) ? entities_.declare_temporary(call) : EntityId()));
  add_site(facts_.subscribes, filters_.of_attached(call));
  if (makes_object(call)) {
    note_given_publishers(unit_, flow_, {pointee_of(call->getType()), {call->getArgs(), call->getNumArgs()}},
                          facts_);
    made_object(call);
  }
  if (const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) member_call(member);
  library_call(call);
  add_site(facts_.advertises, library_transport(unit_, call));
  for (PublisherMention& mention : publisher_arguments(unit_, flow_, call))
    publishers_.push_back(std::move(mention));
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return;
  ported_call(call, function);
  if (makes_object(call) || !unit_.declares(function) || library_advertise_rule(unit_, call)) return;
  if (const EntityId result = entities_.declare_result(function); !result.empty()) flow_.follow(call, result);
}

/// tzc::advertise<M>(nh, ...), tzc::publish(pub, message), tzc::subscribe(nh, ...): an earlier run wrote them.
void Collectors::ported_call(const clang::CallExpr* call, const clang::FunctionDecl* function) {
  const MethodCall* rule = unit_.rules.find_ported_function(qualified_name_of(function));
  if (!rule) return;
  if (rule->role == MethodCall::Role::publish) {
    add_site(facts_.publishes, std::optional(attached_publish(unit_, flow_, call)));
  } else if (rule->role == MethodCall::Role::subscribe ||
             rule->role == MethodCall::Role::subscribe_transport) {
    add_site(facts_.subscribes, std::optional(subscribes_.of_ported_call(call, *rule)));
  } else {
    add_site(facts_.advertises, std::optional(advertises_.of_ported_call(call, *rule)));
    flow_.follow(call, entities_.declare_temporary(call));
  }
}

void Collectors::publish(const clang::CXXMemberCallExpr* call) {
  std::optional<PublishCall> published = publish_call(unit_, flow_, call);
  if (!published) return;
  if (published->publisher) publishers_.push_back(std::move(*published->publisher));
  for (const EntityId& chosen : published->publishers.entities)
    entities_.add_flow(published->site.publisher, chosen, {call->getExprLoc(), "one of several publishers"});
  const auto* callee = llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
  if (callee && !published->site.messages.empty())
    retype(entities_, published->site.messages[0], callee->template_arguments());
  add_site(facts_.publishes, std::optional(std::move(published->site)));
}

void Collectors::member_call(const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method || !call->getRecordDecl()) return;
  const std::string object = qualified_name_of(method->getParent());
  const std::string name = method->getNameAsString();
  if (is_publish(call)) return publish(call);
  if (name == "reset")
    hidden_.note(call->getImplicitObjectArgument()->getType(), {call->getArgs(), call->getNumArgs()});
  add_site(facts_.advertises, library_advertise(unit_, call));
  add_site(facts_.publishes, library_publish(unit_, call));
  if (llvm::StringRef(name).starts_with("emplace"))
    note_given_publishers(unit_, flow_,
                          {first_argument(unit_.ast().getRecordType(method->getParent())),
                           {call->getArgs(), call->getNumArgs()}},
                          facts_);
  if (name == "registerCallback") filters_.add_callbacks(call, facts_.filter_callbacks);
  add_site(facts_.subscribes, filters_.of_emplaced(call));
  if (filters_.is_filter(method->getParent()) && name == "subscribe")
    add_site(facts_.subscribes, filters_.of_call(call));
  else if (const MethodCall* rule = unit_.rules.find_method(object, name, written_arguments(call)))
    rule_call(call, *rule);
}

void Collectors::rule_call(const clang::CXXMemberCallExpr* call, const MethodCall& rule) {
  switch (rule.role) {
    case MethodCall::Role::advertise:
    case MethodCall::Role::advertise_transport:
      add_site(facts_.advertises, std::optional(advertises_.of_call(call, rule)));
      flow_.follow(call, entities_.declare_temporary(call));
      return;
    case MethodCall::Role::subscribe:
    case MethodCall::Role::subscribe_transport:
      if (written_arguments(call) == 1 && are_of_pattern(call->getArg(0))) return;  // the instances subscribe
      add_site(facts_.subscribes, std::optional(subscribes_.of_call(call, rule)));
      return;
    case MethodCall::Role::builds_message:
      if (const EntityId id = entities_.declare_temporary(call); !id.empty()) {
        flow_.follow(call, id);
        add(allocations_.of_adapter(call, id, rule));
      }
      return;
    case MethodCall::Role::fills_message:
    case MethodCall::Role::publish:
      return;
  }
}

void Collectors::escapes(const std::vector<const clang::FunctionDecl*>& functions,
                         const std::vector<const clang::MemberExpr*>& arrays) {
  EscapeContext context{unit_, entities_, flow_, facts_, hidden_};
  EscapeAnalysis analysis(context);
  SharedMats mats(context);
  for (const clang::FunctionDecl* function : functions) {
    const SeenFunction seen = analysis.analyse(function);
    const FunctionView& view = seen.view;
    note_body(function, facts_);
    const ThreadCode code(context, view);
    for (const clang::Stmt* stmt : view.statements()) {
      const std::string usr = usr_of(pattern_of(function));
      if (may_synchronize(stmt)) facts_.locking.insert(usr);
      if (runs_window_callbacks(stmt)) facts_.effects[usr].push_back(call_of(window_callbacks));
      if (may_synchronize(stmt) || runs_window_callbacks(stmt))
        facts_.synchronizing.insert(code.around(stmt));
      if (code.hands_over(stmt)) facts_.handing_over.insert(code.around(stmt));
    }
    for (ElementUse& use : element_uses(context, seen)) facts_.element_uses.push_back(std::move(use));
    contents(context, seen, code);
    note_given_messages(unit_, view, facts_);
    mats.analyse(view);
  }
  analysis.finish();
  mats.finish();
  for (const clang::MemberExpr* array : arrays) {
    const clang::FunctionDecl* around = enclosing_function(unit_.ast(), *array);
    const bool in_template = around && around->isDependentContext();  // its instances tell
    if (!analysis.has_seen(array) && !in_template)
      analysis.escape(context.sources_of(array->getBase()), "may start outside of a function",
                      array->getBeginLoc(), false);
  }
}

/// A closure that goes to others is called when they like, as a callback is: besides the function that makes it.
void Collectors::contents(EscapeContext& context, const SeenFunction& seen, const ThreadCode& code) {
  if (std::optional<ContentFlow> flow = content_flow(context, seen))
    facts_.add_content(usr_of(pattern_of(seen.view.function())), std::move(*flow));
  for (const clang::Stmt* stmt : seen.view.statements()) {
    const auto* closure = llvm::dyn_cast<clang::LambdaExpr>(stmt);
    if (!closure || !code.hands_over(closure)) continue;
    for (ContentFlow& flow : closure_flows(context, seen, closure))
      facts_.add_content(closure_name(unit_, closure), std::move(flow));
  }
}

/// Calls in a member's default initializer run before later members exist.
void Collectors::early_calls(const clang::Stmt* stmt) {
  const auto* call = llvm::dyn_cast_or_null<clang::CallExpr>(stmt);
  const auto* made = llvm::dyn_cast_or_null<clang::CXXConstructExpr>(stmt);
  const clang::FunctionDecl* callee = call ? call->getDirectCallee() : nullptr;
  if (made) callee = made->getConstructor();
  if (callee && unit_.declares(callee)) facts_.early.insert(usr_of(pattern_of(callee)));
  if (stmt)
    for (const clang::Stmt* child : stmt->children()) early_calls(child);
}

Facts Collectors::finish() {
  for (const auto& [where, part] : parts_) add(allocations_.of_part(part.second, part.first));
  leave_to_instances(drafts_);
  for (AllocationDraft& draft : drafts_)
    facts_.allocations.push_back(connected(unit_, std::move(draft), publishers_));
  facts_.hidden_code = hidden_.shown();
  static_cast<EntityFacts&>(facts_) = entities_.take();
  facts_.const_casts = flow_.const_casts();
  facts_.foreign_casts = flow_.foreign_casts();
  if (facts_.programs.empty()) facts_.parts.insert(main_file(unit_));
  return std::move(facts_);
}

}  // namespace tzc::rewriter
