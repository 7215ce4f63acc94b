// SPDX-License-Identifier: BSD-3-Clause
#include "facts/sites/factories.h"

#include "facts/syntax/calls.h"

namespace tzc::rewriter {
namespace {

/// The place behind the parenthesis that follows the name.
std::optional<Place> behind_paren(const Unit& unit, clang::SourceLocation from, clang::SourceLocation to) {
  std::optional<Place> place = unit.source.place(clang::SourceRange(from, to));
  if (!place) return {};
  const std::size_t paren = unit.source.text(*place).find('(');
  if (paren == std::string::npos) return {};
  place->begin = place->end = place->begin + static_cast<unsigned>(paren) + 1;
  return place;
}

bool may_take_another_parameter(const clang::FunctionDecl* function) {
  const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
  if (method && (method->isVirtual() || method->getParent()->isLambda())) return false;
  return !function->isTemplated() && !function->getTemplateInstantiationPattern() &&
         !function->isVariadic() && !function->isOverloadedOperator() &&
         !llvm::isa<clang::CXXConversionDecl>(function);
}

/// Builds its result in a variable of its own, or passes on what another one builds.
bool returns_message(const Unit& unit, const clang::FunctionDecl* function) {
  const auto carried = carried_by(function->getReturnType(), unit.rules);
  return carried && carried->role == EntityRole::message;
}

std::string parameter_name(const Unit& unit, const clang::FunctionDecl* function) {
  const bool taken = unit.source.text(function->getSourceRange()).find("publisher") != std::string::npos;
  return taken ? "tzc_publisher" : "publisher";
}

}  // namespace

std::optional<Factory> factory_of(const Unit& unit, const clang::FunctionDecl* function) {
  if (!function->isThisDeclarationADefinition() || !unit.declares(function) ||
      !returns_message(unit, function) || !may_take_another_parameter(function))
    return {};
  Factory factory;
  factory.parameter = parameter_name(unit, function);
  factory.has_parameters = function->getNumParams() > 0;
  for (const clang::FunctionDecl* redeclaration : function->redecls()) {
    const clang::FunctionTypeLoc type = redeclaration->getFunctionTypeLoc();
    const auto at = type ? behind_paren(unit, type.getLParenLoc(), type.getRParenLoc()) : std::nullopt;
    if (!at || (!factory.has_parameters &&
                unit.source.text(clang::SourceRange(type.getLParenLoc(), type.getRParenLoc())) != "()"))
      return {};
    factory.declarations.push_back(*at);
  }
  return factory;
}

std::optional<AllocationDraft> factory_call(const Unit& unit, EntityTable& entities,
                                            const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) || !unit.declares(function) ||
      !returns_message(unit, function) || !may_take_another_parameter(function))
    return {};
  AllocationDraft draft = draft_at(unit, entities, entities.declare_result(function), *call);
  draft.site.where = unit.location(call->getExprLoc());
  FactoryAllocation how{entities.result_id(function), {}};
  const char* separator = written_arguments(call) > 0 ? ", " : "";
  if (const auto at = behind_paren(unit, call->getCallee()->getEndLoc(), call->getRParenLoc()))
    how.changes.push_back({*at, std::string("$PUB") + separator, "factory", {}});
  draft.site.how = std::move(how);
  return draft;
}

}  // namespace tzc::rewriter
