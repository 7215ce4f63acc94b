// SPDX-License-Identifier: BSD-3-Clause
#include "facts/publish_events.h"

#include <clang/AST/DeclTemplate.h>

#include "facts/known_functions.h"

namespace tzc::rewriter {
namespace {

bool involves(const Unit& unit, clang::QualType type, unsigned depth);

bool involves(const Unit& unit, const clang::TemplateArgument& argument, unsigned depth) {
  if (argument.getKind() == clang::TemplateArgument::Type) return involves(unit, argument.getAsType(), depth);
  return argument.getKind() == clang::TemplateArgument::Pack &&
         llvm::any_of(argument.pack_elements(),
                      [&](const clang::TemplateArgument& part) { return involves(unit, part, depth); });
}

bool involves(const Unit& unit, clang::QualType type, unsigned depth) {
  if (type.isNull() || depth > 5) return depth > 5;
  type = type.getNonReferenceType().getCanonicalType();
  if (type->isPointerType() || type->isMemberPointerType())
    return type->isFunctionPointerType() || type->isMemberFunctionPointerType() ||
           involves(unit, type->getPointeeType(), depth + 1);
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record) return false;
  if (unit.source.in_package(record->getLocation()))
    return !record->hasDefinition() || !record->isTrivial() || record->isLambda();
  if (record->getName() == "function" || record->getName() == "_Bind") return true;
  const auto* made = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  return made && llvm::any_of(made->getTemplateArgs().asArray(), [&](const clang::TemplateArgument& one) {
           return involves(unit, one, depth + 1);
         });
}

/// Whether a function that the compiler writes calls code of the package: for the parts of the class.
bool parts_involve_package(const Unit& unit, const clang::CXXRecordDecl* record) {
  if (!record->hasDefinition()) return true;
  return llvm::any_of(record->fields(),
                      [&](const clang::FieldDecl* f) { return involves(unit, f->getType(), 0); }) ||
         llvm::any_of(record->bases(),
                      [&](const clang::CXXBaseSpecifier& base) { return involves(unit, base.getType(), 0); });
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
    return std::move(events_);
  }

 private:
  void look_at(const clang::Stmt* stmt);
  void look_at_call(const clang::CallExpr* call);
  void look_at_construction(const clang::CXXConstructExpr* construct);
  void look_at_end(const clang::DeclStmt* declaration);
  void look_at_exchange(const clang::MemberExpr* array);
  bool is_own_lambda(const clang::FunctionDecl* function) const;
  bool is_harmless(const clang::FunctionDecl* function, llvm::ArrayRef<const clang::Expr*> arguments) const;
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

/// The bodies of lambdas of this function are looked at as part of it.
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

bool EventFinder::is_own_lambda(const clang::FunctionDecl* function) const {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (!method || !method->getParent()->isLambda()) return false;
  return llvm::any_of(view_.statements(), [&](const clang::Stmt* stmt) {
    const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt);
    return lambda && lambda->getLambdaClass() == method->getParent() && !lambda->isGenericLambda();
  });
}

bool EventFinder::is_harmless(const clang::FunctionDecl* function,
                              llvm::ArrayRef<const clang::Expr*> arguments) const {
  if (function->getBuiltinID() != 0 && function->isExternC()) return true;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method && message_of(method->getParent())) return true;
  if (!calls_nothing(qualified_name_of(function))) return false;
  // A lambda of this function that is handed over is part of the function's text.
  return llvm::none_of(arguments, [&](const clang::Expr* argument) {
    const clang::CXXRecordDecl* record = argument->getType()->getAsCXXRecordDecl();
    return !(record && record->isLambda()) && involves_package(context_.unit, argument->getType());
  });
}

void EventFinder::add_call(const clang::Stmt* at, const clang::FunctionDecl* function,
                           llvm::ArrayRef<const clang::Expr*> arguments) {
  PublishEvent event;
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(function);
  const bool seen = function && context_.unit.declares(function) && !(method && method->isVirtual());
  if (function && is_own_lambda(function)) return;
  if (function && !context_.unit.declares(function) && is_harmless(function, arguments)) return;
  if (method && method->isTrivial()) return;
  if (method && method->isDefaulted() && !method->isUserProvided() &&
      !parts_involve_package(context_.unit, method->getParent()))
    return;
  event.kind = seen ? PublishEvent::Kind::call : PublishEvent::Kind::unknown;
  if (seen) event.callee = usr_of(pattern_of(function));
  event.messages = messages_in(arguments);
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
  }
  add_call(call, function, arguments);
}

void EventFinder::look_at_construction(const clang::CXXConstructExpr* construct) {
  add_call(construct, construct->getConstructor(),
           llvm::ArrayRef<const clang::Expr*>(construct->getArgs(), construct->getNumArgs()));
}

/// Destructors of locals run at the end of their block.
void EventFinder::look_at_end(const clang::DeclStmt* declaration) {
  const clang::Stmt* block = view_.parent(declaration);
  for (const clang::Decl* decl : declaration->decls()) {
    const auto* variable = llvm::dyn_cast<clang::VarDecl>(decl);
    if (!variable || variable->isStaticLocal() || !involves_package(context_.unit, variable->getType()))
      continue;
    const clang::CXXRecordDecl* record = variable->getType()->getAsCXXRecordDecl();
    if (!record || (record->hasDefinition() && record->hasTrivialDestructor()) || record->isLambda())
      continue;
    PublishEvent event;
    const clang::CXXDestructorDecl* destructor = record->getDestructor();
    if (destructor && !destructor->isUserProvided() && !parts_involve_package(context_.unit, record))
      continue;
    if (destructor && !destructor->isVirtual() && context_.unit.declares(destructor)) {
      event.kind = PublishEvent::Kind::call;
      event.callee = usr_of(destructor->getCanonicalDecl());
    }
    const unsigned end = block ? view_.span(block).exit : ~0U;
    add(std::move(event), declaration, {end, end});
  }
}

void EventFinder::look_at(const clang::Stmt* stmt) {
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) return look_at_call(call);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(stmt))
    return look_at_construction(construct);
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(stmt)) {
    const clang::CXXDestructorDecl* destructor = bound->getTemporary()->getDestructor();
    if (destructor && context_.unit.declares(destructor)) add_call(stmt, destructor, {});
  }
  if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt)) look_at_end(declaration);
  if (const auto* array = llvm::dyn_cast<clang::MemberExpr>(stmt)) look_at_exchange(array);
}

}  // namespace

std::set<EntityId> messages_of(EscapeContext& context, const clang::Expr* expr) {
  const std::vector<EntityId> sources = context.sources_of(expr);
  std::set<EntityId> messages(sources.begin(), sources.end());
  add_mentioned(context, expr, messages);
  return messages;
}

bool involves_package(const Unit& unit, clang::QualType type) {
  return involves(unit, type, 0);
}

std::vector<SeenEvent> publish_events(EscapeContext& context, const FunctionView& view) {
  return EventFinder(context, view).run();
}

}  // namespace tzc::rewriter
