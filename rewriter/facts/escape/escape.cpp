// SPDX-License-Identifier: BSD-3-Clause
// Where references to a message's data start, and what they must not live across.
#include "facts/escape/escape.h"

#include <clang/AST/Attr.h>

#include <algorithm>
#include <tuple>

#include "facts/escape/array_writes.h"
#include "facts/escape/filled_message.h"
#include "facts/escape/held_locks.h"
#include "facts/escape/threads.h"
#include "facts/escape/type_questions.h"
#include "facts/escape/written_types.h"
#include "facts/syntax/ast_walk.h"
#include "facts/syntax/bodies.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

bool is_repeated(const FunctionView& view, FunctionView::Span event, FunctionView::Span use,
                 unsigned declared) {
  return llvm::any_of(view.repeated(), [&](const FunctionView::Span& loop) {
    return loop.contains(event) && loop.contains(use) && declared < loop.enter;
  });
}

/// Whether the use may come after the event, for a variable that was there before it.
bool comes_after(const FunctionView& view, const SeenEvent& event, const clang::Stmt* use,
                 unsigned declared) {
  const FunctionView::Span here = view.span(use);
  if (event.span.contains(here)) return false;  // an argument: it was evaluated before
  if (view.jumps() || is_repeated(view, event.span, here, declared)) return true;
  if (event.lambda && !view.runs_within(view.lambda_around(use), event.lambda)) return true;
  if (declared > event.span.exit) return false;
  const bool same_statement = view.full_expression(use) == view.full_expression(event.at);
  return same_statement || here.enter > event.span.exit;
}

/// data[i] = event(): since C++17 the right operand of an assignment is evaluated before the left one.
bool is_assigned_after(const FunctionView& view, const clang::Stmt* born, const SeenEvent& event) {
  for (const clang::Stmt* around = view.parent(born); around; around = view.parent(around)) {
    const clang::Expr* value = nullptr;
    if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(around); op && op->isAssignmentOp())
      value = op->getLHS() == born ? op->getRHS() : nullptr;
    if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(around); op && op->isAssignmentOp())
      value = op->getArg(0) == born ? op->getArg(1) : nullptr;
    if (value && view.span(value).contains(event.span)) return true;
    born = around;
  }
  return false;
}

/// image.data[same.data[0]]: the number is read before anything else happens.
bool is_read_at_once(const FunctionView& view, const clang::Expr* born) {
  const clang::Stmt* around = view.parent(born);
  while (llvm::isa_and_nonnull<clang::ParenExpr>(around)) around = view.parent(around);
  const auto* cast = llvm::dyn_cast_or_null<clang::ImplicitCastExpr>(around);
  return cast && cast->getCastKind() == clang::CK_LValueToRValue && !may_hold_pointer(cast->getType());
}

/// A parameter of a closure begins with the closure's body: each call has its own, which is gone when the call returns. A function's
/// parameters are there from the start; so are those of a closure's body that is looked at by itself.
unsigned declared_at(const FunctionView& view, const clang::VarDecl* variable) {
  if (const clang::DeclStmt* declaration = view.declaration(variable)) return view.span(declaration).enter;
  const auto* closure = llvm::dyn_cast<clang::CXXMethodDecl>(variable->getDeclContext());
  const bool is_parameter = llvm::isa<clang::ParmVarDecl>(variable) && closure && is_lambda(closure);
  return is_parameter ? view.span(closure->getBody()).enter : 0;
}

/// Tells threads' events apart.
class ThreadEvents {
 public:
  ThreadEvents(const EscapeContext& context, const FunctionView& view)
      : code_(context, view), locks_(code_, view) {}

  PublishEvent of(const SeenEvent& seen) const {
    PublishEvent event = seen.event;
    event.locks = locks_.at(seen.at);
    const std::string code = code_.around(seen.at);
    if (!is_closure(code)) return event;
    event.closure = code;
    event.captured = names_captured(seen.at);
    return event;
  }

 private:
  ThreadCode code_;
  HeldLocks locks_;
};

/// Of what is not seen one event says as much as many.
void add_effect(std::vector<PublishEvent>& effects, PublishEvent event) {
  const auto says_it = [&](const PublishEvent& other) {
    return other.kind == PublishEvent::Kind::unknown && other.messages.empty() &&
           other.if_shown.covers(event.if_shown) &&
           std::tie(other.closure, other.captured, other.locks) ==
               std::tie(event.closure, event.captured, event.locks);
  };
  const bool is_known = event.kind == PublishEvent::Kind::unknown && event.messages.empty() &&
                        std::any_of(effects.begin(), effects.end(), says_it);
  if (!is_known) effects.push_back(std::move(event));
}

/// In a constructor's initializers: members that are declared later do not exist yet.
bool is_before_body(const FunctionView& view, const clang::Stmt* stmt) {
  while (const clang::Stmt* around = view.parent(stmt)) stmt = around;
  return stmt != view.function()->getBody();
}

}  // namespace

void EscapeAnalysis::escape(const std::vector<EntityId>& messages, const std::string& how,
                            clang::SourceLocation where, bool ends_with_scope) {
  for (const EntityId& key : messages)
    context_.found.escapes.push_back(
        {key,
         {codes::TZC1003, "a pointer into its data " + how, location_of(context_.unit.source.where(where))},
         ends_with_scope});
}

void EscapeAnalysis::cast_const_away(const Referring& what) {
  const Obstacle why{codes::TZC2002, "const is cast away from its data",
                     location_of(context_.unit.source.where(what.expr->getBeginLoc()))};
  for (const EntityId& key : what.messages)
    context_.found.data_writes.push_back({key, why, what.how == Reference::array});
}

EscapeAnalysis::Analysed& EscapeAnalysis::analysed(const clang::FunctionDecl* definition) {
  auto [known, is_new] = functions_.try_emplace(definition);
  if (is_new) {
    known->second.view = std::make_unique<FunctionView>(definition);
    known->second.events = publish_events(context_, *known->second.view);
    known->second.writes = array_writes(context_, *known->second.view);
  }
  return known->second;
}

SeenFunction EscapeAnalysis::analyse(const clang::FunctionDecl* definition) {
  const Analysed& here = analysed(definition);
  const ThreadEvents threads(context_, *here.view);
  std::vector<PublishEvent>& effects = context_.found.effects[usr_of(pattern_of(definition))];
  for (const SeenEvent& event : here.events) {
    if (is_before_body(*here.view, event.at) && !event.event.callee.empty())
      context_.found.early.insert(event.event.callee);
    if (event.event.kind != PublishEvent::Kind::exchange) add_effect(effects, threads.of(event));
    if (!event.event.messages.empty()) note_tail(context_, *here.view, here.events, event);
  }
  for (const SeenEvent& write : here.writes) effects.push_back(threads.of(write));
  for (const clang::Stmt* stmt : here.view->statements()) {
    note_lasting(stmt);
    start(*here.view, stmt);
  }
  check_types(*here.view);
  return {*here.view, here.events};
}

/// No lifetime excuses a question about a type.
void EscapeAnalysis::check_types(const FunctionView& view) {
  const std::vector<const clang::Expr*> questions = type_questions(context_.unit, view);
  if (questions.empty()) return;
  escape(messages_named(context_, view), "has a type that the program asks for",
         questions.front()->getBeginLoc(), false);
}

/// Static locals live on; what a closure holds may be published wherever the closure is called.
void EscapeAnalysis::note_lasting(const clang::Stmt* stmt) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt);
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  if (!variable || !(variable->isStaticLocal() || reference->refersToEnclosingVariableOrCapture())) return;
  if (const EntityId id = context_.entities.declare(variable); !id.empty()) context_.found.lasting.insert(id);
}

void EscapeAnalysis::start(const FunctionView& view, const clang::Stmt* stmt) {
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt)) {
    if (!is_data_array(member->getType())) return;
    seen_.insert(member);
    const std::set<EntityId> messages = messages_of(context_, member->getBase());
    const bool read_only = member->getType().isConstQualified();
    if (!messages.empty())
      climb(view, {member, Reference::array, read_only, {messages.begin(), messages.end()}});
  }
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(stmt)) {
    if (!is_cloud_iterator(construct->getConstructor()->getParent()) || construct->getNumArgs() < 2) return;
    const std::vector<EntityId> sources = context_.sources_of(construct->getArg(0));
    const bool read_only = construct->getConstructor()->getParent()->getName().contains("Const");
    if (!sources.empty()) climb(view, {construct, Reference::view, read_only, sources});
  }
  if (const clang::Expr* cloud = cloud_of_emplaced_iterator(stmt))
    escape(context_.sources_of(cloud), "is kept in a container", stmt->getBeginLoc(), false);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt); call && makes_object(call)) {
    const clang::QualType made = pointee_of(call->getType());
    if (made.isNull() || !is_cloud_iterator(made->getAsCXXRecordDecl()) || call->getNumArgs() == 0) return;
    const std::vector<EntityId> sources = context_.sources_of(call->getArg(0));
    if (!sources.empty()) climb(view, {call, Reference::elements, false, sources});
  }
}

void EscapeAnalysis::climb(const FunctionView& view, const Referring& from) {
  const Referring born = climb_reference(context_, view, *this, from);
  if (born.expr) check_expression(view, born);
}

void EscapeAnalysis::hold(const FunctionView& view, const Holder& holder) {
  std::vector<EntityId> unknown;
  for (const EntityId& key : holder.messages) {
    const std::string id = std::to_string(reinterpret_cast<std::uintptr_t>(holder.variable)) + " " +
                           key.text() + (holder.how == Reference::array ? " array" : "") +
                           (holder.read_only ? " const" : "");
    if (held_.insert(id).second) unknown.push_back(key);
  }
  if (unknown.empty()) return;
  const Holder next{holder.variable, holder.how, holder.read_only, std::move(unknown)};
  if (next.variable->hasAttr<clang::CleanupAttr>())
    escape(next.messages, "is given to a function where the scope of its variable ends",
           next.variable->getLocation(), false);
  for (const clang::DeclRefExpr* use : view.uses(holder.variable)) {
    const Referring from{use, next.how, next.read_only, next.messages};
    next.how == Reference::array ? climb(view, from) : void(climb_reference(context_, view, *this, from));
  }
  next.how == Reference::array ? note_writes(view, next) : check_holder(view, next);
}

/// What const access gave is left behind by a write through any name of the array.
void EscapeAnalysis::note_writes(const FunctionView& view, const Holder& array) {
  Analysed& here = analysed(view.function());
  const ThreadEvents threads(context_, view);
  for (SeenEvent& write : writes_through(view, array.variable, array.messages)) {
    context_.found.effects[usr_of(pattern_of(view.function()))].push_back(threads.of(write));
    here.named_writes.push_back(std::move(write));
  }
}

void EscapeAnalysis::finish() {
  for (const auto& [function, here] : functions_) {
    for (const Holder& reader : here.readers) check_events(*here.view, reader, here.named_writes);
    for (const Referring& born : here.read) check_expression(*here.view, born, here.named_writes);
  }
}

void EscapeAnalysis::take(const FunctionView& view, const clang::VarDecl* vector, const clang::Expr* at,
                          const std::vector<EntityId>& messages) {
  if (!held_.insert(std::to_string(reinterpret_cast<std::uintptr_t>(vector)) + " taken").second)
    return escape(messages,
                  "may exist: '" + vector->getNameAsString() + "' gives its elements more than once",
                  at->getBeginLoc(), false);
  for (const clang::DeclRefExpr* use : view.uses(vector))
    if (!view.span(at).contains(view.span(use))) climb(view, {use, Reference::array, false, messages});
}

bool EscapeAnalysis::follow(const clang::FunctionDecl* function, unsigned argument, const Referring& what) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  const clang::FunctionDecl* definition = shown_body(function);
  if (!definition || definition->isDependentContext() || (method && method->isVirtual()) ||
      argument >= definition->getNumParams())
    return false;
  const clang::ParmVarDecl* parameter = definition->getParamDecl(argument);
  const bool by_value = !parameter->getType()->isReferenceType();
  const bool is_another_array =
      what.how == Reference::array && !is_written_out(context_.unit.ast(), parameter->getType());
  if (by_value && !is_another_array && !may_hold_pointer(parameter->getType())) return true;
  hold(*analysed(definition).view, {parameter, what.how, what.read_only, what.messages});
  return true;
}

void EscapeAnalysis::add_hold(const Holder& holder, const PublishEvent& event, clang::SourceLocation where) {
  const std::string who = holder.variable
                              ? "'" + holder.variable->getNameAsString() + "' points into its data and"
                              : "a pointer into its data";
  const bool is_write = event.kind == PublishEvent::Kind::write;
  const std::string what = is_write ? "its data was written to" : "the message may have been published";
  const bool may_be_write = holder.read_only && event.kind == PublishEvent::Kind::call;
  const Obstacle obstacle{codes::TZC1003,
                          who + " is used after " + what + (may_be_write ? " or written to" : ""),
                          location_of(context_.unit.source.where(where))};
  for (const EntityId& key : holder.messages)
    context_.found.holds.push_back({key, event, obstacle, holder.read_only});
}

/// A pointer without a name lives as long as the expression around it; what it is computed from comes before it.
void EscapeAnalysis::check_expression(const FunctionView& view, const Referring& born) {
  Analysed& here = analysed(view.function());
  check_expression(view, born, here.events);
  if (!born.read_only || is_read_at_once(view, born.expr)) return;
  check_expression(view, born, here.writes);
  here.read.push_back(born);
}

void EscapeAnalysis::check_expression(const FunctionView& view, const Referring& born,
                                      const std::vector<SeenEvent>& events) {
  const FunctionView::Span whole = view.span(view.full_expression(born.expr));
  const FunctionView::Span here = view.span(born.expr);
  const bool ordered = context_.unit.ast().getLangOpts().CPlusPlus17;
  for (const SeenEvent& event : events)
    if (whole.contains(event.span) && !event.span.contains(here) && !here.contains(event.span) &&
        !(ordered && is_assigned_after(view, born.expr, event)))
      add_hold({nullptr, Reference::elements, born.read_only, born.messages}, event.event,
               born.expr->getBeginLoc());
}

void EscapeAnalysis::check_holder(const FunctionView& view, const Holder& holder) {
  Analysed& here = analysed(view.function());
  check_events(view, holder, here.events);
  if (!holder.read_only) return;
  check_events(view, holder, here.writes);
  here.readers.push_back(holder);
}

void EscapeAnalysis::check_events(const FunctionView& view, const Holder& holder,
                                  const std::vector<SeenEvent>& events) {
  const unsigned declared = declared_at(view, holder.variable);
  for (const SeenEvent& event : events)
    for (const clang::DeclRefExpr* use : view.uses(holder.variable))
      if (comes_after(view, event, use, declared)) {
        add_hold(holder, event.event, use->getLocation());
        break;
      }
}

}  // namespace tzc::rewriter
