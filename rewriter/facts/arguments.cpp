// SPDX-License-Identifier: BSD-3-Clause
// What becomes of a value that is handed to a function or a constructor.
#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

Carrier carrier_of(Unit& unit, const Key& key) {
  return unit.facts.entities[key].carrier;
}

void hand_out(Unit& unit, const Key& key, const std::string& receiver, clang::SourceLocation where) {
  const Carrier carrier = carrier_of(unit, key);
  if (carrier == Carrier::filter) return;
  const std::string reason = "it is handed to '" + receiver + "', which is not part of the package";
  add_obstacle(unit, key, carrier == Carrier::publisher ? codes::TZC1010 : codes::TZC1002, reason, where);
}

void use_rule(Unit& unit, const Key& key, clang::SourceRange name, const std::string& to, const char* rule,
              const char* header) {
  unit.facts.data_uses.push_back({key, location_of(unit.source.where(name.getBegin())), true});
  if (const std::optional<Place> where = unit.source.place(name))
    unit.facts.uses.push_back({key, {*where, to, rule, {header}}});
  else
    add_obstacle(unit, key, codes::TZC1006, "the call comes from a macro", name.getBegin());
}

clang::SourceRange callee_name(const clang::CallExpr* call) {
  const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(call->getCallee()->IgnoreParenImpCasts());
  return reference ? reference->getNameInfo().getSourceRange().isValid()
                         ? clang::SourceRange(reference->getBeginLoc(), reference->getNameInfo().getEndLoc())
                         : clang::SourceRange()
                   : clang::SourceRange();
}

/// img.toImageMsg(message) -> to_image_msg(img, message)
void use_method_rule(Unit& unit, const Key& key, const clang::CXXMemberCallExpr* call,
                     const MethodCall& rule) {
  unit.facts.data_uses.push_back({key, location_of(unit.source.where(call->getBeginLoc())), true});
  for (const Change& change : receiver_first(unit, call, rule.to, rule.rule, rule.header))
    unit.facts.uses.push_back({key, change});
  if (receiver_first(unit, call, rule.to, rule.rule, rule.header).empty())
    add_obstacle(unit, key, codes::TZC1006, "the call comes from a macro", call->getBeginLoc());
}

Handed hand_to_package(Unit& unit, const Key& key, const clang::FunctionDecl* function, unsigned argument,
                       clang::SourceLocation where) {
  const std::string name = function->getNameAsString();
  if (argument >= function->getNumParams()) {
    add_obstacle(unit, key, codes::TZC1001, "it is a variable argument of '" + name + "'", where);
    return Handed::done;
  }
  const Key parameter = declare(unit, function->getParamDecl(argument));
  if (!parameter.empty())
    add_flow(unit, key, parameter, where, "passed to '" + name + "'");
  else if (!function->getParamDecl(argument)->getType()->isScalarType())
    add_obstacle(unit, key, codes::TZC1001, "it is converted when passed to '" + name + "'", where);
  return Handed::done;
}

Handed hand_to_method(Unit& unit, const Key& key, const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  const std::string object = qualified_name_of(method->getParent());
  const std::string name = method->getNameAsString();
  if (is_publisher_class(object) && name == "publish") return Handed::done;
  if (const MethodCall* rule = unit.rules.find_method(object, name, written_arguments(call))) {
    if (rule->role == MethodCall::Role::fills_message) use_method_rule(unit, key, call, *rule);
    return Handed::done;
  }
  const clang::Expr* container = call->getImplicitObjectArgument();
  if (carried_by(container->getType(), unit.rules)) {
    const Sources sources = sources_of(unit, container);
    for (const Key& target : sources.keys)
      add_flow(unit, key, target, call->getBeginLoc(), "stored by '" + name + "'");
    if (!sources.foreign) return Handed::done;
  }
  hand_out(unit, key, object + "::" + name, call->getBeginLoc());
  return Handed::done;
}

bool swaps(const std::string& function) {
  return function == "std::swap" || function == "boost::swap";
}

Handed hand_to_swap(Unit& unit, const Key& key, const clang::CallExpr* call) {
  for (const clang::Expr* argument : call->arguments())
    for (const Key& other : sources_of(unit, argument).keys)
      add_flow(unit, key, other, call->getBeginLoc(), "swapped");
  return Handed::done;
}

}  // namespace

Handed hand_to_call(Unit& unit, const Key& key, const clang::CallExpr* call, unsigned argument) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) {
    if (!call->isTypeDependent())
      add_obstacle(unit, key, codes::TZC1001, "it is handed to a function that is not known here",
                   call->getBeginLoc());
    return Handed::done;
  }
  const std::string name = qualified_name_of(function);
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) && llvm::isa<clang::CXXMethodDecl>(function) &&
      argument > 0)
    --argument;
  if (makes_object(call)) {
    add_flow(unit, key, declare_temporary(unit, call), call->getBeginLoc(), "copied into a new object");
    return Handed::done;
  }
  if (passes_through(function)) return Handed::result;
  const bool casts = name == "boost::const_pointer_cast" || name == "std::const_pointer_cast";
  if (casts && serves_plain_field(unit, call)) return Handed::done;
  if (casts) add_obstacle(unit, key, codes::TZC2002, "const is cast away from it", call->getBeginLoc());
  if (swaps(name)) return hand_to_swap(unit, key, call);
  if (const LibraryCall* rule = unit.rules.find_call(name, argument)) {
    use_rule(unit, key, callee_name(call), rule->to, rule->rule, rule->header);
    return Handed::done;
  }
  if (is_package_function(unit, function))
    return hand_to_package(unit, key, function, argument, call->getBeginLoc());
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call))
    return hand_to_method(unit, key, method);
  if (function->isInStdNamespace() && carried_by(call->getType(), unit.rules)) return Handed::result;
  hand_out(unit, key, name, call->getBeginLoc());
  return Handed::done;
}

Handed hand_to_constructor(Unit& unit, const Key& key, const clang::CXXConstructExpr* construct,
                           unsigned argument) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  if (unit.source.in_package(pattern_of(constructor)->getLocation()))
    return hand_to_package(unit, key, constructor, argument, construct->getBeginLoc());
  if (carried_by(construct->getType(), unit.rules)) return Handed::result;
  hand_out(unit, key, qualified_name_of(constructor->getParent()), construct->getBeginLoc());
  return Handed::done;
}

}  // namespace tzc::rewriter
