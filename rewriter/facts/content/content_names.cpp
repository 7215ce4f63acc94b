// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/content_names.h"

#include "facts/content/empty_copies.h"
#include "facts/content/started_pointers.h"
#include "facts/flow/message_copies.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {
namespace {

using Kind = ContentEvent::Kind;

bool is_pointer(clang::QualType type) {
  return !pointee_of(type).isNull();
}

}  // namespace

bool takes_elements(const clang::CXXOperatorCallExpr* assignment) {
  const clang::FunctionDecl* function = assignment->getDirectCallee();
  return function && function->getNumParams() == 1 &&
         function->getParamDecl(0)->getType()->isRValueReferenceType();
}

bool is_made_empty(const clang::Expr* source) {
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(source->IgnoreUnlessSpelledInSource());
  return made && made->getNumArgs() == 0;
}

void ContentNames::variable(const clang::VarDecl* variable) {
  const clang::Expr* const init = variable->getInit();
  const MessagePart root = parts_.root_of(variable);
  const bool is_reference = variable->getType()->isReferenceType();
  if (is_reference && parts_.name_of(variable) != root) return log_.any(init);
  log_.assign(root, true, variable->getLocation());
  if (!init) return;
  if (names_messages(variable->getType())) return may_lead_to(root, init);
  if (is_reference || is_iterator(variable->getType()) || is_pointer_to_array(variable->getType()))
    return alias(root, init);
  if (is_message_or_pointer(variable->getType())) made_from(variable, root);
}

/// A message by value, or a pointer to one. A copy that is written as an assignment has the memory that is allocated in front of it.
void ContentNames::made_from(const clang::VarDecl* variable, const MessagePart& root) {
  if (has_memory_for_copy(unit_, variable)) return log_.assign(root, false, variable->getLocation());
  const clang::Expr* source = variable->getInit();
  const bool by_pointer = is_pointer(variable->getType());
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(source->IgnoreImplicit());
  const bool moves = made && made->getConstructor()->isMoveConstructor();
  const bool copies_pointer = by_pointer && made && made->getConstructor()->isCopyConstructor();
  if (moves || copies_pointer) source = made->getArg(0);
  MessagePart part = parts_.part_of(source);
  const bool is_empty = is_made_empty(source) || (by_pointer && starts_with_new_message(source));
  if (part.empty() && !is_empty) log_.assign(root, false, variable->getLocation());
  if (by_pointer && (!moves || is_result(part))) return alias(root, source);
  log_.pair(Kind::exchange, root, std::move(part), variable->getLocation());
}

/// The name, where it is one that is known, leads to what the expression denotes.
void ContentNames::alias(MessagePart pointer, const clang::Expr* to) {
  log_.pair(Kind::alias, std::move(pointer), parts_.part_of(to), to->getExprLoc());
  log_.any(to);
}

/// The name may lead to what the source denotes, or to what the source is made from.
void ContentNames::may_lead_to(const MessagePart& name, const clang::Expr* source) {
  source = source->IgnoreParens();
  if (name.empty() || !message_reached(source->getType())) return;
  if (MessagePart part = parts_.part_of(source); !part.empty())
    return log_.pair(Kind::perhaps, name, std::move(part), source->getExprLoc());
  const clang::Expr* const inner = source->IgnoreImplicit();
  if (inner != source) return may_lead_to(name, inner);
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(source)) {
    for (const clang::Expr* argument : made->arguments()) may_lead_to(name, argument);
  } else if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(source)) {
    for (const clang::Expr* part : list->inits()) may_lead_to(name, part);
  } else {
    log_.any(source);
  }
}

/// flag ? front_ : back_, std::tie(front_, back_)
void ContentNames::choice(const clang::Expr* expr, llvm::ArrayRef<const clang::Expr*> ways) {
  const clang::QualType type = expr->getType();
  if (!message_reached(type) || (expr->isPRValue() && holds_messages(type) && !is_stock_or_twin(type)))
    return;
  const MessagePart root = parts_.part_of(expr);
  log_.assign(root, true, expr->getExprLoc());
  for (const clang::Expr* way : ways) may_lead_to(root, way);
}

/// One that returns one of several messages, or puts pointers into a container.
void ContentNames::library_call(const clang::CallExpr* call) {
  if (!call->getDirectCallee() || unit_.declares(call->getDirectCallee())) return;
  const std::vector<const clang::Expr*> sources = message_sources(call);
  if (sources.size() < 2) return;
  choice(call, sources);
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  const clang::CXXMethodDecl* decl = method ? method->getMethodDecl() : nullptr;
  if (!decl || decl->isConst() || !names_messages(method->getImplicitObjectArgument()->getType())) return;
  const MessagePart container = parts_.part_of(method->getImplicitObjectArgument());
  for (const clang::Expr* source : llvm::ArrayRef(sources).drop_front())
    if (!container.empty()) may_lead_to(container + "[in]", source);
}

void ContentNames::member(const clang::FieldDecl* field, const clang::Expr* init) {
  if (const auto* by_default = llvm::dyn_cast<clang::CXXDefaultInitExpr>(init)) init = by_default->getExpr();
  if (!is_name_of_message(field->getType())) return;
  may_lead_to(parts_.root_of(field), init);
  if (is_pointer(field->getType()) && starts_with_new_message(init))
    log_.add(Kind::make, parts_.root_of(field), init->getExprLoc());
}

/// Camera{&frame_, pub_}
void ContentNames::aggregate(const clang::InitListExpr* list) {
  const clang::CXXRecordDecl* record = list->getType()->getAsCXXRecordDecl();
  if (!record || !unit_.source.in_package(record->getLocation())) return;
  unsigned index = record->getNumBases();
  for (const clang::FieldDecl* field : record->fields())
    if (index < list->getNumInits()) member(field, list->getInit(index++));
}

void ContentNames::assignment(const clang::CXXOperatorCallExpr* call) {
  const clang::Expr* const target = call->getArg(0);
  if (call->getOperator() != clang::OO_Equal) return;
  const clang::Expr* const source = call->getArg(1);
  MessagePart part = parts_.part_of(target), other = parts_.part_of(source);
  if (is_iterator(target->getType())) return alias(std::move(part), source);
  if (names_messages(target->getType())) return may_lead_to(part, source);
  if (!is_message_or_pointer(target->getType())) return;
  const bool by_pointer = is_pointer(target->getType());
  const bool moves = takes_elements(call) && !(by_pointer && is_result(other));
  if (!by_pointer || moves || !outlives_functions(other))
    log_.assign(part, !by_pointer && is_made_empty(source), call->getExprLoc());
  if (moves)
    log_.pair(Kind::exchange, std::move(part), std::move(other), call->getExprLoc());
  else if (by_pointer)
    alias(std::move(part), source);
}

/// A message by value takes its content along, as does a pointer that owns it; others are another name of what they lead to.
void ContentNames::returned(const clang::ReturnStmt* stmt) {
  const clang::Expr* const value = stmt->getRetValue();
  const clang::LambdaExpr* const lambda = view_.lambda_around(stmt);
  const clang::FunctionDecl* const function = lambda ? lambda->getCallOperator() : view_.function();
  if (!value || !returns_message(function)) return;
  const MessagePart result = result_root(usr_of(pattern_of(function)));
  log_.add(Kind::reset, result, stmt->getReturnLoc());
  if (function->getReturnType()->isReferenceType()) return alias(result, value);
  const bool by_pointer = is_pointer(value->getType());
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(value->IgnoreImplicit());
  const bool copies = made && copied_message(made);
  if (made &&
      (made->getNumArgs() == 0 || !(by_pointer || copies || made->getConstructor()->isMoveConstructor())))
    return;
  MessagePart part = parts_.part_of(made && !copies ? made->getArg(0) : value);
  const bool stays = value->getType()->isPointerType() || (by_pointer && !is_local(part));
  log_.pair(stays ? Kind::alias : Kind::exchange, result, std::move(part), stmt->getReturnLoc());
  if (by_pointer) log_.any(value);
}

/// [copy = image]: a variable of the closure.
void ContentNames::captured(const clang::LambdaExpr* lambda) {
  for (const clang::LambdaCapture& capture : lambda->captures())
    if (lambda->isInitCapture(&capture))
      if (const auto* one = llvm::dyn_cast<clang::VarDecl>(capture.getCapturedVar())) variable(one);
}

void ContentNames::look_at(const clang::Stmt* stmt) {
  const auto* expr = llvm::dyn_cast<clang::Expr>(stmt);
  if (const clang::Expr* original = expr ? copied_message(expr) : nullptr) {
    if (copies_nothing(view_, parts_, expr))
      log_.assign(parts_.part_of(expr), true, expr->getBeginLoc());
    else
      log_.copy(parts_.part_of(expr), parts_.part_of(original), expr->getBeginLoc());
  }
  if (const auto* lambda = llvm::dyn_cast<clang::LambdaExpr>(stmt)) {
    captured(lambda);
  } else if (const auto* declaration = llvm::dyn_cast<clang::DeclStmt>(stmt)) {
    for (const clang::Decl* decl : declaration->decls())
      if (const auto* one = llvm::dyn_cast<clang::VarDecl>(decl); one && !one->isStaticLocal()) variable(one);
  } else if (const auto* statement = llvm::dyn_cast<clang::ReturnStmt>(stmt)) {
    returned(statement);
  } else if (const auto* conditional = llvm::dyn_cast<clang::ConditionalOperator>(stmt)) {
    choice(conditional, {conditional->getTrueExpr(), conditional->getFalseExpr()});
  } else if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(stmt)) {
    aggregate(list);
    if (is_list_of_messages(list)) choice(list, list->inits());
  } else if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(stmt)) {
    const bool is_name = is_message_or_pointer(op->getType()) || is_pointer_to_array(op->getType());
    if (op->getOpcode() == clang::BO_Assign && is_name)
      alias(parts_.part_of(op->getLHS()), op->getRHS());  // current_ = &frames_[i]
  } else if (const auto* assigned = llvm::dyn_cast<clang::CXXOperatorCallExpr>(stmt)) {
    assignment(assigned);
  } else if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) {
    library_call(call);
  }
}

}  // namespace tzc::rewriter
