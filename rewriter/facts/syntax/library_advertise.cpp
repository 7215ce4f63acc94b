// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/library_advertise.h"

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/message_type.h"

namespace tzc::rewriter {

llvm::ArrayRef<clang::TemplateArgumentLoc> written_arguments_of(const clang::CallExpr* call) {
  const clang::Expr* callee = call->getCallee()->IgnoreParenImpCasts();
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(callee)) return member->template_arguments();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(callee)) return name->template_arguments();
  return {};
}

clang::QualType library_advertised_type(const clang::CallExpr* call) {
  const llvm::ArrayRef<clang::TemplateArgumentLoc> arguments = written_arguments_of(call);
  if (arguments.empty() || arguments[0].getArgument().getKind() != clang::TemplateArgument::Type) return {};
  const clang::QualType type = arguments[0].getArgument().getAsType();
  return message_of(type) || twin_message_of(type) || is_pcl_cloud(type) ? type : clang::QualType();
}

namespace {

/// The rule for the publisher that a function returns which is called `advertise...`; null: it is none.
const LibraryAdvertise* rule_of_result(const Unit& unit, const clang::FunctionDecl* function) {
  if (!function || !function->getIdentifier() || !function->getName().starts_with("advertise"))
    return nullptr;
  const clang::CXXRecordDecl* result = function->getReturnType().getCanonicalType()->getAsCXXRecordDecl();
  return result ? unit.rules.find_advertiser(qualified_name_of(result)) : nullptr;
}

}  // namespace

bool advertises_for_callers(const Unit& unit, const clang::FunctionDecl* function) {
  return rule_of_result(unit, function) && unit.declares(function) && unit.exports(function);
}

const LibraryAdvertise* library_advertise_rule(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  const LibraryAdvertise* rule = rule_of_result(unit, function);
  if (!rule || call->isTypeDependent() || (unit.declares(function) && !unit.exports(function)))
    return nullptr;
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method && qualified_name_of(method->getParent()) == rule->owner) return nullptr;
  return !rule->is_template || !library_advertised_type(call).isNull() ? rule : nullptr;
}

const clang::CallExpr* attaching_call(const Unit& unit, const clang::CallExpr* call, const std::string& to) {
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *call)) {
    const auto* parent = node.get<clang::Expr>();
    if (const auto* outer = llvm::dyn_cast_or_null<clang::CallExpr>(parent)) {
      const clang::FunctionDecl* function = outer->getDirectCallee();
      return function && qualified_name_of(function) == to ? outer : nullptr;
    }
    if (!parent || !is_implicit_wrapper(parent)) return nullptr;
  }
  return nullptr;
}

bool attaches_publisher(const Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return false;
  const std::string name = qualified_name_of(function);
  return llvm::any_of(unit.rules.advertisers, [&](const LibraryAdvertise* rule) { return name == rule->to; });
}

}  // namespace tzc::rewriter
