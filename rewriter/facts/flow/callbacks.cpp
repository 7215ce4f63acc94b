// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/callbacks.h"

#include <clang/AST/DeclTemplate.h>

#include "facts/flow/deleters.h"
#include "facts/syntax/ast_walk.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// nh.subscribe(...), sync.registerCallback(...), options.init<M>(...)
bool is_subscribing(const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function || !function->getIdentifier()) return false;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  const bool of_options = method && method->getParent()->getName() == "SubscribeOptions";
  return function->getName().starts_with("subscribe") || function->getName() == "registerCallback" ||
         of_options;
}

/// Whether a callback is given to something that subscribes, bound or wrapped or as it is.
template <class Callback>
bool is_subscribed(const Unit& unit, const Callback& callback) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), callback)) {
    const auto* expr = node.get<clang::Expr>();
    if (!expr) return false;
    const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
    if (call && is_subscribing(call)) return true;
    const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
    if (made && made->getConstructor()->getParent()->getName().contains("Subscriber")) return true;
  }
  return false;
}

}  // namespace

/// Whether the name only stands for the function in a call of it.
bool CallbackPins::is_callee(const clang::DeclRefExpr* reference) const {
  const auto* cast = parent_as<clang::ImplicitCastExpr>(unit_.ast(), *reference);
  const clang::Expr* named = cast ? static_cast<const clang::Expr*>(cast) : reference;
  const auto* call = parent_as<clang::CallExpr>(unit_.ast(), *named);
  return call && call->getCallee() == named;
}

bool CallbackPins::check_address_taken(const clang::FunctionDecl* function,
                                       const clang::DeclRefExpr* reference) {
  if (!unit_.declares(function) || is_callee(reference)) return false;
  const std::string name = function->getNameAsString();
  if (is_named_as_deleter(unit_, reference)) return true;
  const std::optional<BoundCall> bound = binding(reference);
  const bool subscribes = is_subscribed(unit_, *reference);
  for (unsigned i = 0; i < function->getNumParams(); ++i) {
    const clang::Expr* given = bound ? bound->given(i) : nullptr;
    const auto carried = given ? carried_by(given->getType(), unit_.rules) : std::nullopt;
    // A publisher that is bound here has the type that the package gives it.
    if (!carried || carried->role != EntityRole::publisher) pin(function->getParamDecl(i), name, subscribes);
  }
  if (const EntityId id = entities_.declare_result(function); !id.empty())
    entities_.add_obstacle(id, codes::TZC1005, "'" + name + "' is called through its address",
                           reference->getLocation());
  return true;
}

bool CallbackPins::is_kept(const clang::LambdaExpr* lambda) const {
  for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *lambda)) {
    if (const auto* variable = node.get<clang::VarDecl>())
      if (const auto* record = variable->getType()->getAsCXXRecordDecl(); record && record->isLambda())
        return true;
    const auto* statement = node.get<clang::Stmt>();
    if (!statement ||
        !llvm::isa<clang::ImplicitCastExpr, clang::MaterializeTemporaryExpr, clang::CXXConstructExpr,
                   clang::CXXBindTemporaryExpr, clang::FullExpr>(statement))
      return false;
  }
  return false;
}

/// A generic one takes what it is given, as it is. What it is subscribed with is a received message, which stays a stock one.
void CallbackPins::check_lambda(const clang::LambdaExpr* lambda) {
  if (!unit_.source.in_package(lambda->getBeginLoc()) || is_kept(lambda)) return;
  if (is_named_as_deleter(unit_, lambda)) return;
  const bool subscribes = is_subscribed(unit_, *lambda);
  for (const clang::ParmVarDecl* parameter : lambda->getCallOperator()->parameters())
    pin(parameter, "lambda", subscribes);
  const clang::FunctionTemplateDecl* pattern = lambda->getLambdaClass()->getDependentLambdaCallOperator();
  if (!pattern || !subscribes) return;
  for (const clang::FunctionDecl* instance : pattern->specializations())
    for (const clang::ParmVarDecl* parameter : instance->parameters()) pin(parameter, "lambda", true);
}

/// The call around a function's name that binds the function; none: its address goes elsewhere.
std::optional<BoundCall> CallbackPins::binding(const clang::DeclRefExpr* reference) const {
  for (const clang::DynTypedNode& node : ancestors(unit_.ast(), *reference)) {
    const auto* expr = node.get<clang::Expr>();
    if (!expr) return {};
    if (const std::optional<BoundCall> bound = bound_call(unit_, expr); bound && bound->name == reference)
      return bound;
    if (llvm::isa<clang::CallExpr>(expr)) return {};
  }
  return {};
}

void CallbackPins::pin(const clang::ParmVarDecl* parameter, const std::string& name, bool subscribes) {
  const EntityId id = entities_.declare(parameter);
  if (id.empty()) return;
  if (entities_.is_message(id) && subscribes)
    entities_.add_obstacle(id, codes::TZC1004, "it comes in through the callback '" + name + "'",
                           parameter->getLocation());
  else
    entities_.add_obstacle(id, codes::TZC1005, "it is a parameter of '" + name + "', which other code calls",
                           parameter->getLocation());
}

}  // namespace tzc::rewriter
