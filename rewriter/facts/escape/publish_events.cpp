// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/publish_events.h"

#include <clang/AST/Attr.h>

#include "facts/escape/hidden_calls.h"
#include "facts/syntax/library_calls.h"
#include "facts/syntax/package_types.h"
#include "facts/syntax/plain_access.h"

namespace tzc::rewriter {
namespace {

/// thread_local Node node: its constructor runs in each thread where that first names it.
bool may_start_with_use(const Unit& unit, const clang::Stmt* stmt) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt);
  const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt);
  const clang::ValueDecl* named =
      reference ? reference->getDecl() : (member ? member->getMemberDecl() : nullptr);
  const auto* variable = llvm::dyn_cast_or_null<clang::VarDecl>(named);
  if (!variable || variable->isStaticLocal() || variable->getTLSKind() != clang::VarDecl::TLS_Dynamic)
    return false;
  if (!unit.source.in_package(variable->getLocation())) return false;
  const clang::VarDecl* definition = variable->getDefinition();
  const bool is_constant = definition && (!definition->getInit() || definition->hasConstantInitialization());
  return !is_constant || variable->getType().isDestructedType() != clang::QualType::DK_none;
}

void add_mentioned(EscapeContext& context, const clang::Stmt* stmt, std::set<EntityId>& messages) {
  if (!stmt) return;
  EntityId key;
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(stmt))
    key = context.entities.declare(reference->getDecl());
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt))
    key = context.entities.declare(member->getMemberDecl());
  if (!key.empty() && context.entities.is_message(key)) messages.insert(key);
  for (const clang::Stmt* child : stmt->children()) add_mentioned(context, child, messages);
}

class EventFinder {
 public:
  EventFinder(EscapeContext& context, const FunctionView& view) : context_(context), view_(view) {}

  std::vector<SeenEvent> run() {
    for (const clang::Stmt* stmt : view_.statements()) look_at(stmt);
    look_at_parts();
    return std::move(events_);
  }

 private:
  void look_at(const clang::Stmt* stmt);
  void look_at_call(const clang::CallExpr* call);
  void look_at_construction(const clang::CXXConstructExpr* construct);
  void look_at_end(const clang::DeclStmt* declaration);
  void look_at_names(const clang::DeclStmt* declaration);
  void look_at_parts();
  void look_at_unwritten(const clang::Stmt* use, const clang::Expr* value);
  void look_at_initializers(const clang::Stmt* use, const clang::CXXMethodDecl* constructor);
  void end_of(const clang::Stmt* at, unsigned when, clang::QualType type);
  void look_at_exchange(const clang::MemberExpr* array);
  bool is_own_lambda(const clang::FunctionDecl* function) const;
  void look_at_delete(const clang::CXXDeleteExpr* stmt);
  void look_at_handler(const clang::CXXCatchStmt* handler);
  void add_hidden(const clang::Stmt* at, FunctionView::Span span, clang::QualType type, bool releases);
  void add_call(const clang::Stmt* at, const clang::FunctionDecl* function,
                llvm::ArrayRef<const clang::Expr*> arguments);
  void add(PublishEvent event, const clang::Stmt* at, FunctionView::Span span) {
    events_.push_back({std::move(event), at, span, view_.lambda_around(at)});
  }
  std::set<EntityId> messages_in(llvm::ArrayRef<const clang::Expr*> arguments);

  EscapeContext& context_;
  const FunctionView& view_;
  std::vector<SeenEvent> events_;
};

std::set<EntityId> EventFinder::messages_in(llvm::ArrayRef<const clang::Expr*> arguments) {
  std::set<EntityId> messages;
  for (const clang::Expr* argument : arguments) {
    const auto carried = carried_by(argument->getType(), context_.unit.rules);
    if (!carried || carried->role != EntityRole::message) continue;
    messages.merge(messages_of(context_, argument));
  }
  return messages;
}

/// array.swap(vector), array = std::move(vector)
void EventFinder::look_at_exchange(const clang::MemberExpr* array) {
  if (!is_data_array(array->getType())) return;
  const clang::Stmt* around = view_.parent(array);
  const auto* method = llvm::dyn_cast_or_null<clang::MemberExpr>(around);
  const auto* assignment = llvm::dyn_cast_or_null<clang::CXXOperatorCallExpr>(around);
  const bool swaps = method && method->getMemberDecl()->getNameAsString() == "swap";
  const bool takes = assignment && assignment->getOperator() == clang::OO_Equal &&
                     assignment->getArg(0) == array && assignment->getArg(1)->isXValue();
  if (!swaps && !takes) return;
  const std::vector<EntityId> sources = context_.sources_of(array->getBase());
  PublishEvent event{PublishEvent::Kind::exchange, {sources.begin(), sources.end()}, {}};
  const clang::Stmt* whole = view_.full_expression(array);
  add(std::move(event), whole, view_.span(whole));
}

/// The bodies of lambdas of this function are looked at as part of it.
bool EventFinder::is_own_lambda(const clang::FunctionDecl* function) const {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (!method || !method->getParent()->isLambda()) return false;
  return llvm::any_of(view_.statements(), [&](const clang::Stmt* stmt) {
    const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt);
    return lambda && lambda->getLambdaClass() == method->getParent() && !lambda->isGenericLambda();
  });
}

/// What a library does with an object of the type may run code of the package that no argument shows.
void EventFinder::add_hidden(const clang::Stmt* at, FunctionView::Span span, clang::QualType type,
                             bool releases) {
  const std::optional<IfShown> at_end = releases ? context_.hidden.at_end_of(type) : std::nullopt;
  const std::optional<IfShown> runs = either(at_end, context_.hidden.in_library_with(type));
  if (!runs) return;
  PublishEvent event;
  event.if_shown = *runs;
  add(std::move(event), at, span);
}

/// delete object
void EventFinder::look_at_delete(const clang::CXXDeleteExpr* stmt) {
  if (context_.unit.declares(stmt->getOperatorDelete())) add_call(stmt, stmt->getOperatorDelete(), {});
  const clang::QualType type = stmt->getDestroyedType();
  const clang::CXXRecordDecl* record = type.isNull() ? nullptr : type->getAsCXXRecordDecl();
  const clang::CXXDestructorDecl* destructor =
      record && record->hasDefinition() ? record->getDestructor() : nullptr;
  if (destructor && may_end_derived(destructor)) return add({}, stmt, view_.span(stmt));
  if (destructor && involves_package(context_.unit, type)) return add_call(stmt, destructor, {});
  if (record) add_hidden(stmt, view_.span(stmt), type, true);
}

/// catch (Error error): it is a copy of what was thrown.
void EventFinder::look_at_handler(const clang::CXXCatchStmt* handler) {
  const clang::VarDecl* caught = handler->getExceptionDecl();
  if (!caught || caught->getType()->isReferenceType() || !involves_package(context_.unit, caught->getType()))
    return;
  const FunctionView::Span span = view_.span(handler);
  add({}, handler, {span.enter, span.enter});
  add({}, handler, {span.exit, span.exit});
}

void EventFinder::add_call(const clang::Stmt* at, const clang::FunctionDecl* function,
                           llvm::ArrayRef<const clang::Expr*> arguments) {
  PublishEvent event;
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(function);
  const bool seen = context_.unit.declares_all_of(function);
  if (function && is_own_lambda(function)) return;
  if (function && calls_no_package_code(context_.unit, function, arguments)) {
    if (is_plain_access(context_.unit, function)) return;  // nor code that its types hide
    const bool releases = !llvm::isa<clang::CXXConstructorDecl>(function) && !(method && method->isConst());
    for (const clang::Expr* argument : arguments) {
      add_hidden(at, view_.span(at), argument->getType(), releases);
      if (releases && may_call_back(argument->getType())) add({}, at, view_.span(at));
    }
    return;
  }
  if (method && method->isTrivial()) return;
  if (method && method->isDefaulted() && !method->isUserProvided() &&
      !parts_involve_package(context_.unit, method->getParent())) {
    look_at_initializers(at, method);
    return add_hidden(at, view_.span(at), method->getThisType()->getPointeeType(),
                      !llvm::isa<clang::CXXConstructorDecl>(method));
  }
  event.kind = seen ? PublishEvent::Kind::call : PublishEvent::Kind::unknown;
  if (seen) event.callee = usr_of(pattern_of(function));
  event.messages = messages_in(arguments);
  // What it returns may be published already.
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(at)) event.messages.merge(messages_in({call}));
  add(std::move(event), at, view_.span(at));
}

void EventFinder::look_at_call(const clang::CallExpr* call) {
  std::vector<const clang::Expr*> arguments(call->arg_begin(), call->arg_end());
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (const auto* member = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) {
    const clang::CXXMethodDecl* method = member->getMethodDecl();
    if (method && method->getNameAsString() == "publish" && call->getNumArgs() > 0 &&
        is_publisher_class(qualified_name_of(method->getParent())))
      return add({PublishEvent::Kind::publish, messages_in(arguments), {}}, call, view_.span(call));
    if (const clang::Expr* object = member->getImplicitObjectArgument()) arguments.push_back(object);
    const auto* destructor = llvm::dyn_cast_or_null<clang::CXXDestructorDecl>(method);
    if (destructor && may_end_derived(destructor)) return add({}, call, view_.span(call));
  }
  add_call(call, function, arguments);
}

void EventFinder::look_at_construction(const clang::CXXConstructExpr* construct) {
  add_call(construct, construct->getConstructor(),
           llvm::ArrayRef<const clang::Expr*>(construct->getArgs(), construct->getNumArgs()));
}

/// An object of the type ends.
void EventFinder::end_of(const clang::Stmt* at, unsigned when, clang::QualType type) {
  type = context_.unit.ast().getBaseElementType(type);
  const FunctionView::Span span{when, when};
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (type.isDestructedType() == clang::QualType::DK_none || (record && record->isLambda())) return;
  if (!involves_package(context_.unit, type)) return add_hidden(at, span, type, true);
  const clang::CXXDestructorDecl* destructor =
      record && record->hasDefinition() ? record->getDestructor() : nullptr;
  if (destructor && !destructor->isUserProvided() && !parts_involve_package(context_.unit, record))
    return add_hidden(at, span, type, true);
  PublishEvent event;
  if (destructor && !destructor->isVirtual() && context_.unit.declares_all_of(destructor)) {
    event.kind = PublishEvent::Kind::call;
    event.callee = usr_of(destructor->getCanonicalDecl());
  }
  add(std::move(event), at, span);
}

/// Locals end with their block, and so does a temporary that one of them is a reference to.
void EventFinder::look_at_end(const clang::DeclStmt* declaration) {
  const clang::Stmt* block = view_.parent(declaration);
  const unsigned end = block ? view_.span(block).exit : ~0U;
  for (const clang::Decl* decl : declaration->decls())
    if (const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl); variable && !variable->isStaticLocal()) {
      end_of(declaration, end, object_type_of(variable));
      if (variable->hasAttr<clang::CleanupAttr>()) add({}, declaration, {end, end});
    }
}

/// auto [first, second] = pair: of a class that is like a tuple, get() gives them.
void EventFinder::look_at_names(const clang::DeclStmt* declaration) {
  for (const clang::Decl* decl : declaration->decls())
    if (const auto* parts = llvm::dyn_cast<clang::DecompositionDecl>(decl))
      for (const clang::BindingDecl* part : parts->bindings())
        if (const clang::VarDecl* holder = part->getHoldingVar())
          look_at_unwritten(declaration, holder->getInit());
}

/// The members and bases of an object end with its destructor.
void EventFinder::look_at_parts() {
  const auto* destructor = llvm::dyn_cast<clang::CXXDestructorDecl>(view_.function());
  if (!destructor) return;
  const clang::Stmt* body = destructor->getBody();
  const unsigned end = view_.span(body).exit;
  for (const clang::FieldDecl* field : destructor->getParent()->fields()) end_of(body, end, field->getType());
  for (const clang::CXXBaseSpecifier& base : destructor->getParent()->bases())
    end_of(body, end, base.getType());
}

/// Default arguments and initializers are evaluated where they are used, once for each use.
void EventFinder::look_at_unwritten(const clang::Stmt* use, const clang::Expr* value) {
  std::vector<const clang::Stmt*> open{value};
  while (!open.empty()) {
    const clang::Stmt* stmt = open.back();
    open.pop_back();
    if (!stmt) continue;
    const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt);
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(stmt);
    if (call) add_call(use, call->getDirectCallee(), {call->getArgs(), call->getNumArgs()});
    if (made) add_call(use, made->getConstructor(), {made->getArgs(), made->getNumArgs()});
    open.insert(open.end(), stmt->child_begin(), stmt->child_end());
  }
}

/// A constructor that the compiler writes evaluates the members' default initializers.
void EventFinder::look_at_initializers(const clang::Stmt* use, const clang::CXXMethodDecl* constructor) {
  const auto* made = llvm::dyn_cast<clang::CXXConstructorDecl>(constructor);
  if (!made || made->isCopyOrMoveConstructor()) return;
  for (const clang::FieldDecl* field : made->getParent()->fields())
    if (field->hasInClassInitializer()) look_at_unwritten(use, field->getInClassInitializer());
}

void EventFinder::look_at(const clang::Stmt* stmt) {
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) return look_at_call(call);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return look_at_construction(construct);
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(stmt)) {
    const clang::CXXDestructorDecl* destructor = bound->getTemporary()->getDestructor();
    if (destructor && context_.unit.declares(destructor)) add_call(stmt, destructor, {});
    const clang::Stmt* whole = view_.full_expression(stmt);
    if (destructor) add_hidden(stmt, view_.span(whole), bound->getType(), true);
  }
  if (const auto* made = llvm::dyn_cast<clang::CXXNewExpr>(stmt))
    if (context_.unit.declares(made->getOperatorNew())) add_call(stmt, made->getOperatorNew(), {});
  if (const auto* deletion = llvm::dyn_cast<clang::CXXDeleteExpr>(stmt)) look_at_delete(deletion);
  if (const auto* handler = llvm::dyn_cast<clang::CXXCatchStmt>(stmt)) look_at_handler(handler);
  // Who resumes a coroutine has run anything meanwhile.
  if (llvm::isa<clang::AsmStmt, clang::CoroutineSuspendExpr>(stmt) || may_start_with_use(context_.unit, stmt))
    add({}, stmt, view_.span(stmt));
  if (const auto* use = llvm::dyn_cast<clang::CXXDefaultArgExpr>(stmt))
    look_at_unwritten(use, use->getExpr());
  if (const auto* use = llvm::dyn_cast<clang::CXXDefaultInitExpr>(stmt))
    look_at_unwritten(use, use->getExpr());
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt)) {
    look_at_names(declaration);
    look_at_end(declaration);
  }
  if (const auto* array = llvm::dyn_cast<clang::MemberExpr>(stmt)) look_at_exchange(array);
}

}  // namespace

std::set<EntityId> messages_of(EscapeContext& context, const clang::Expr* expr) {
  const std::vector<EntityId> sources = context.sources_of(expr);
  std::set<EntityId> messages(sources.begin(), sources.end());
  add_mentioned(context, expr, messages);
  return messages;
}

std::vector<SeenEvent> publish_events(EscapeContext& context, const FunctionView& view) {
  return EventFinder(context, view).run();
}

}  // namespace tzc::rewriter
