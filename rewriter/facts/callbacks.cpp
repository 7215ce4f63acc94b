// SPDX-License-Identifier: BSD-3-Clause
#include "facts/callbacks.h"

#include "facts/ast_walk.h"
#include "model/codes.h"

namespace tzc::rewriter {

/// Whether the name only stands for the function in a call of it.
bool CallbackPins::is_callee(const clang::DeclRefExpr* reference) const {
  const auto* cast = parent_as<clang::ImplicitCastExpr>(unit_.ast(), *reference);
  const clang::Expr* named = cast ? static_cast<const clang::Expr*>(cast) : reference;
  const auto* call = parent_as<clang::CallExpr>(unit_.ast(), *named);
  return call && call->getCallee() == named;
}

void CallbackPins::check_address_taken(const clang::FunctionDecl* function,
                                       const clang::DeclRefExpr* reference) {
  if (!unit_.declares(function) || is_callee(reference)) return;
  const std::string name = function->getNameAsString();
  const std::optional<BoundCall> bound = binding(reference);
  for (unsigned i = 0; i < function->getNumParams(); ++i) {
    const clang::Expr* given = bound ? bound->given(i) : nullptr;
    const auto carried = given ? carried_by(given->getType(), unit_.rules) : std::nullopt;
    // A publisher that is bound here has the type that the package gives it.
    if (!carried || carried->role != EntityRole::publisher) pin(function->getParamDecl(i), name);
  }
  if (const EntityId id = entities_.declare_result(function); !id.empty())
    entities_.add_obstacle(id, codes::TZC1005, "'" + name + "' is called through its address",
                           reference->getLocation());
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

void CallbackPins::check_lambda(const clang::LambdaExpr* lambda) {
  if (!unit_.source.in_package(lambda->getBeginLoc()) || is_kept(lambda)) return;
  for (const clang::ParmVarDecl* parameter : lambda->getCallOperator()->parameters())
    pin(parameter, "lambda");
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

void CallbackPins::pin(const clang::ParmVarDecl* parameter, const std::string& name) {
  const EntityId id = entities_.declare(parameter);
  if (id.empty()) return;
  entities_.add_obstacle(id, entities_.is_message(id) ? codes::TZC1004 : codes::TZC1005,
                         "it comes in through the callback '" + name + "'", parameter->getLocation());
}

}  // namespace tzc::rewriter
