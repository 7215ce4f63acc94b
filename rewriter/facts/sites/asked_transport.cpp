// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/asked_transport.h"

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <set>

#include "facts/sites/later_writes.h"
#include "facts/syntax/calls.h"
#include "model/facts.h"
#include "parse/names.h"

namespace tzc::rewriter {
namespace {

bool is_of_class(const clang::Expr* expr, const char* name) {
  const clang::CXXRecordDecl* record =
      expr->getType().getNonReferenceType().getCanonicalType()->getAsCXXRecordDecl();
  return record && qualified_name_of(record) == name;
}

/// The value that a local variable keeps, in place of its name.
const clang::Expr* initial_value(const clang::Expr* expr) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr->IgnoreParenImpCasts());
  const auto* variable = reference ? llvm::dyn_cast<clang::VarDecl>(reference->getDecl()) : nullptr;
  const bool keeps_it =
      variable && variable->isLocalVarDecl() && variable->getInit() && !may_change_later(variable);
  return keeps_it ? variable->getInit() : expr;
}

/// ros::TransportHints().unreliable().reliable(): the first one that is called is tried first.
bool asks_for_udp(const clang::Expr* hints) {
  static const std::set<std::string> tcp = {"reliable", "tcp"}, udp = {"unreliable", "udp"};
  bool is_udp = false;
  for (const clang::Expr* expr = hints->IgnoreImplicit();;) {
    const auto* call = llvm::dyn_cast<clang::CXXMemberCallExpr>(expr->IgnoreParenImpCasts());
    if (!call || !call->getMethodDecl()) return is_udp;
    const std::string name = call->getMethodDecl()->getNameAsString();
    if (tcp.count(name) != 0 || udp.count(name) != 0) is_udp = udp.count(name) != 0;
    expr = call->getImplicitObjectArgument()->IgnoreImplicit();
  }
}

}  // namespace

std::string asked_transport(llvm::ArrayRef<const clang::Expr*> arguments) {
  for (const clang::Expr* argument : arguments) {
    if (is_of_class(argument, "image_transport::TransportHints")) {
      const std::optional<std::string> name = constant_string(initial_value(argument));
      if (name && *name != "raw") return "the transport '" + *name + "'";
    }
    if (is_of_class(argument, "ros::TransportHints") && asks_for_udp(initial_value(argument))) return udpros;
  }
  return "";
}

}  // namespace tzc::rewriter
