// SPDX-License-Identifier: BSD-3-Clause
#include "facts/escape/shared_mats.h"

#include "facts/escape/shared_types.h"
#include "facts/syntax/calls.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

const clang::ValueDecl* canonical(const clang::ValueDecl* decl) {
  return llvm::cast<clang::ValueDecl>(decl->getCanonicalDecl());
}

/// What a call gives to a parameter of the function; null: nothing that is written there.
const clang::Expr* argument_of(const clang::Expr* mention, unsigned parameter) {
  const auto* call = llvm::dyn_cast<clang::CallExpr>(mention);
  if (!call) return nullptr;
  const bool of_object =
      llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(call->getDirectCallee());
  const unsigned index = parameter + (of_object ? 1 : 0);
  return index < call->getNumArgs() ? call->getArg(index) : nullptr;
}

/// The object that an expression selects a part of, or refers to; null: none.
const clang::Expr* inner(const clang::Expr* expr) {
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getSubExpr();
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return element->getBase();
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expr)) return cast->getSubExpr();
  if (const auto* full = llvm::dyn_cast<clang::FullExpr>(expr)) return full->getSubExpr();
  if (const auto* made = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr)) return made->getSubExpr();
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr))
    return method->getImplicitObjectArgument();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr)) return op->getArg(0);
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  return call && passes_through(call->getDirectCallee()) ? call->getArg(0) : nullptr;
}

}  // namespace

void SharedMats::analyse(const FunctionView& view) {
  views_.push_back(&view);
  for (const clang::Stmt* stmt : view.statements())
    if (shares_message(stmt)) shares_.push_back({&view, llvm::cast<clang::Expr>(stmt)});
}

void SharedMats::index(const FunctionView& view) {
  for (const clang::Stmt* stmt : view.statements()) {
    const clang::ValueDecl* named = nullptr;
    if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(stmt)) named = name->getDecl();
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(stmt)) named = member->getMemberDecl();
    if (const auto* call = llvm::dyn_cast<clang::CallExpr>(stmt)) named = call->getDirectCallee();
    const bool is_name = named && llvm::isa<clang::FunctionDecl>(named) && !llvm::isa<clang::CallExpr>(stmt);
    if (named && !is_name) mentions_[canonical(named)].push_back({&view, llvm::cast<clang::Expr>(stmt)});
  }
}

void SharedMats::finish() {
  if (shares_.empty()) return;
  for (const FunctionView* view : views_) index(*view);
  for (const Mention& share : shares_) {
    const auto messages = context_.sources_of(llvm::cast<clang::CallExpr>(share.expr)->getArg(0));
    current_ = {messages.begin(), messages.end()};
    if (!current_.empty()) SharedClimb(context_, *this, *share.view).run(share.expr);
  }
  while (!open_.empty()) {
    const clang::ValueDecl* holder = open_.front().first;
    current_ = std::move(open_.front().second);
    open_.pop_front();
    for (const Mention& mention : mentions_[holder])
      SharedClimb(context_, *this, *mention.view).run(mention.expr);
  }
}

void SharedMats::hold(const clang::ValueDecl* holder) {
  holder = canonical(holder);
  std::set<EntityId> unknown;
  for (const EntityId& message : current_)
    if (holders_[holder].insert(message).second) unknown.insert(message);
  if (!unknown.empty()) open_.emplace_back(holder, std::move(unknown));
}

void SharedMats::hold_object(const clang::Expr* object) {
  const clang::ValueDecl* named = named_object(object);
  if (!named) return;
  hold(named);
  if (const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(named)) give_back(parameter);
}

/// An output parameter: the callers' objects share the elements, too.
void SharedMats::give_back(const clang::ParmVarDecl* parameter) {
  const auto* function = llvm::dyn_cast<clang::FunctionDecl>(parameter->getDeclContext());
  if (!function || parameter->getType()->getPointeeType().isNull()) return;
  bool is_new = false;
  for (const EntityId& message : current_) is_new |= outputs_.insert({parameter, message}).second;
  if (!is_new) return;
  for (const Mention& mention : mentions_[canonical(function)])
    if (const clang::Expr* given = argument_of(mention.expr, parameter->getFunctionScopeIndex()))
      hold_object(given);
}

/// The variable, or the package's member or function, that an expression begins with.
const clang::ValueDecl* SharedMats::named_object(const clang::Expr* expr) const {
  while (expr) {
    expr = expr->IgnoreParenImpCasts();
    if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return name->getDecl();
    const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
    if (call && context_.unit.declares(call->getDirectCallee())) return call->getDirectCallee();
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) {
      const clang::ValueDecl* field = member->getMemberDecl();
      if (context_.unit.source.in_package(field->getLocation())) return field;
      expr = member->getBase();
    } else {
      expr = inner(expr);
    }
  }
  return nullptr;
}

void SharedMats::write(const clang::Expr* at) {
  const Obstacle why{codes::TZC2001, "the cv::Mat that shares its data may be written to",
                     location_of(context_.unit.source.where(at->getBeginLoc()))};
  for (const EntityId& message : current_)
    if (written_.insert(message).second) context_.found.data_writes.push_back({message, why, false});
}

}  // namespace tzc::rewriter
