// SPDX-License-Identifier: BSD-3-Clause
// Functions that build a message for their callers, far from its publisher. They can be given the publisher:
//   Image make(int n);        ->  tzc::Image make(const tzc::Publisher& publisher, int n);
//   pub.publish(make(3));     ->  pub.publish(make(pub, 3));
#include "facts/unit.h"

namespace tzc::rewriter {
namespace {

/// The place behind the parenthesis that follows the name.
std::optional<Place> behind_paren(Unit& unit, clang::SourceLocation from, clang::SourceLocation to) {
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
bool returns_message(Unit& unit, const clang::FunctionDecl* function) {
  const auto carried = carried_by(function->getReturnType(), unit.rules);
  return carried && carried->carrier == Carrier::message;
}

std::string parameter_name(Unit& unit, const clang::FunctionDecl* function) {
  const bool taken = unit.source.text(function->getSourceRange()).find("publisher") != std::string::npos;
  return taken ? "tzc_publisher" : "publisher";
}

}  // namespace

void collect_helper(Unit& unit, const clang::FunctionDecl* function) {
  if (!function->isThisDeclarationADefinition() || !is_package_function(unit, function) ||
      !returns_message(unit, function) || !may_take_another_parameter(function))
    return;
  Helper helper;
  helper.parameter = parameter_name(unit, function);
  helper.has_parameters = function->getNumParams() > 0;
  for (const clang::FunctionDecl* redeclaration : function->redecls()) {
    const clang::FunctionTypeLoc type = redeclaration->getFunctionTypeLoc();
    const auto at = type ? behind_paren(unit, type.getLParenLoc(), type.getRParenLoc()) : std::nullopt;
    if (!at || (!helper.has_parameters &&
                unit.source.text(clang::SourceRange(type.getLParenLoc(), type.getRParenLoc())) != "()"))
      return;
    helper.declarations.push_back(*at);
  }
  unit.facts.helpers.emplace(usr_of(pattern_of(function)), helper);
}

void collect_helper_call(Unit& unit, const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) || !is_package_function(unit, function) ||
      !returns_message(unit, function) || !may_take_another_parameter(function))
    return;
  const clang::FunctionDecl* around = function_around(unit, *call);
  Birth birth;
  birth.entity = declare_result(unit, function);
  birth.adapter = true;
  birth.calls = usr_of(pattern_of(function));
  birth.where = location_of(unit.source.where(call->getExprLoc()));
  if (around) {
    birth.record = record_usr_of(around);
    birth.function = usr_of(around);
  }
  const char* separator = written_arguments(call) > 0 ? ", " : "";
  if (const auto at = behind_paren(unit, call->getCallee()->getEndLoc(), call->getRParenLoc()))
    birth.changes.push_back({*at, std::string("$PUB") + separator, "helper", {}});
  unit.births.push_back({birth, around});
}

}  // namespace tzc::rewriter
