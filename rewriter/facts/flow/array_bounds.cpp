// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/array_bounds.h"

#include <set>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"
#include "parse/ast_visitor.h"

namespace tzc::rewriter {
namespace {

const ArrayGrowth unknown{};
const ArrayGrowth none{0};

/// Unknown for elements of a type that the unit does not instantiate.
ArrayGrowth elements(const Unit& unit, const clang::MemberExpr* array, std::uint64_t count) {
  constexpr std::uint64_t any = std::uint64_t{1} << 32;
  const auto* vector = llvm::cast<clang::ClassTemplateSpecializationDecl>(
      array->getType().getCanonicalType()->getAsCXXRecordDecl());
  const clang::QualType element = vector->getTemplateArgs()[0].getAsType();
  if (count >= any || element->isIncompleteType()) return unknown;
  return {count * static_cast<std::uint64_t>(unit.ast().getTypeSizeInChars(element).getQuantity())};
}

/// `count` elements, when the compiler knows the number.
ArrayGrowth constant(const Unit& unit, const clang::MemberExpr* array, const clang::Expr* count) {
  clang::Expr::EvalResult value;
  if (count->isValueDependent() || !count->getType()->isIntegerType() ||
      !count->EvaluateAsInt(value, unit.ast()) || value.Val.getInt().isNegative())
    return unknown;
  return elements(unit, array, value.Val.getInt().getLimitedValue());
}

const clang::Expr* without_wrappers(const clang::Expr* expr) {
  for (;;) {
    const clang::Expr* next = expr->IgnoreImplicit();
    if (const auto* list = llvm::dyn_cast<clang::CXXStdInitializerListExpr>(next)) next = list->getSubExpr();
    if (next == expr) return expr;
    expr = next;
  }
}

/// {} and std::vector<T>(), an empty list or vector.
bool is_empty(const clang::CXXConstructExpr* construct) {
  const clang::CXXConstructorDecl* constructor = construct->getConstructor();
  return constructor->isDefaultConstructor() && constructor->getParent()->isInStdNamespace();
}

/// {1, 2, 3} as an argument.
ArrayGrowth listed(const Unit& unit, const clang::MemberExpr* array, const clang::Expr* argument) {
  const clang::Expr* value = without_wrappers(argument);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(value)) {
    if (is_empty(construct)) return none;
    if (construct->isStdInitListInitialization() && construct->getNumArgs() > 0)
      value = without_wrappers(construct->getArg(0));
  }
  const auto* list = llvm::dyn_cast<clang::InitListExpr>(value);
  return list ? elements(unit, array, list->getNumInits()) : unknown;
}

class Jumps : public AstVisitor {
 public:
  bool found = false;
  bool VisitLabelStmt(clang::LabelStmt*) override {
    found = true;
    return false;
  }
};

/// Whether the statement runs at most once between the declaration of `variable` and the end of its life.
bool runs_once(const Unit& unit, const clang::Stmt* stmt, const clang::VarDecl* variable) {
  const auto* declaration = parent_as<clang::DeclStmt>(unit.ast(), *variable);
  const auto* scope = declaration ? parent_as<clang::CompoundStmt>(unit.ast(), *declaration) : nullptr;
  const clang::FunctionDecl* function = scope ? enclosing_function(unit.ast(), *scope) : nullptr;
  if (!function || !function->getBody()) return false;
  Jumps jumps;
  jumps.TraverseStmt(function->getBody());
  for (const clang::DynTypedNode& node : ancestors(unit.ast(), *stmt)) {
    const auto* around = node.get<clang::Stmt>();
    if (around == scope) return !jumps.found;
    if (!around ||
        llvm::isa<clang::ForStmt, clang::WhileStmt, clang::DoStmt, clang::CXXForRangeStmt, clang::LambdaExpr>(
            around))
      return false;
  }
  return false;
}

/// One element more, in an array of a local variable.
ArrayGrowth appended(const Unit& unit, const clang::MemberExpr* array) {
  const clang::Expr* base = array->getBase();
  for (const auto* member = llvm::dyn_cast<clang::MemberExpr>(base->IgnoreParenImpCasts()); member;
       member = llvm::dyn_cast<clang::MemberExpr>(base->IgnoreParenImpCasts())) {
    if (member->isArrow()) return unknown;
    base = member->getBase();
  }
  const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(base->IgnoreParenImpCasts());
  const auto* variable = name ? llvm::dyn_cast<clang::VarDecl>(name->getDecl()) : nullptr;
  if (array->isArrow() || !variable || !variable->hasLocalStorage() ||
      llvm::isa<clang::ParmVarDecl>(variable) || variable->getType()->isReferenceType() ||
      !runs_once(unit, array, variable))
    return unknown;
  return {elements(unit, array, 1).most_bytes, true};
}

/// Whether the array is a field of the message, or of a field of it, and not of an element of an array of messages.
bool is_part_of(const clang::MemberExpr* array, const std::string& message) {
  const clang::Expr* base = array->getBase()->IgnoreParenImpCasts();
  for (;;) {
    const clang::QualType pointee = pointee_of(base->getType());
    const auto found = message_of(pointee.isNull() ? base->getType() : pointee);
    if (found && found->name == message) return true;
    const auto* arrow = llvm::dyn_cast<clang::CXXOperatorCallExpr>(base);
    const auto* member = llvm::dyn_cast<clang::MemberExpr>(base);
    if (arrow && arrow->getOperator() == clang::OO_Arrow)
      base = arrow->getArg(0)->IgnoreParenImpCasts();
    else if (member && found)
      base = member->getBase()->IgnoreParenImpCasts();
    else
      return false;
  }
}

bool keeps_size(const clang::CXXMethodDecl* method) {
  static const std::set<std::string> names = {"at",      "back",     "begin",        "clear",  "data",
                                              "end",     "erase",    "front",        "rbegin", "rend",
                                              "reserve", "pop_back", "shrink_to_fit"};
  return method->isConst() || names.count(method->getNameAsString()) != 0;
}

ArrayGrowth of_method(const Unit& unit, const clang::MemberExpr* array,
                      const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method) return unknown;
  const std::string name = method->getIdentifier() ? method->getNameAsString() : "";
  if (method->getIdentifier() && keeps_size(method)) return none;
  if (name == "push_back" || name == "emplace_back") return appended(unit, array);
  const unsigned count = written_arguments(call);
  if (name == "resize" && count > 0) return constant(unit, array, call->getArg(0));
  if (name != "assign") return unknown;
  if (count == 1) return listed(unit, array, call->getArg(0));
  // assign(count, value); the other form is a template of its iterators.
  return count == 2 && !method->getPrimaryTemplate() ? constant(unit, array, call->getArg(0)) : unknown;
}

ArrayGrowth of_operator(const Unit& unit, const clang::MemberExpr* array,
                        const clang::CXXOperatorCallExpr* call) {
  if (call->getArg(0)->IgnoreParenImpCasts() != array) return unknown;
  if (call->getOperator() == clang::OO_Subscript) return none;
  return call->getOperator() == clang::OO_Equal ? listed(unit, array, call->getArg(1)) : unknown;
}

/// for (float& value : message.data)
bool is_range(const clang::VarDecl* variable) {
  return variable->isImplicit() && !variable->isInitCapture() && variable->getName().starts_with("__range");
}

ArrayGrowth growth_of_mention(const Unit& unit, const clang::MemberExpr* array) {
  const clang::Expr* at = array;
  for (;;) {
    const auto around = written_parent(unit.ast(), clang::DynTypedNode::create(*at));
    const auto* variable = around ? around->get<clang::VarDecl>() : nullptr;
    if (variable && is_range(variable)) return none;
    const auto* parent = around ? around->get<clang::Expr>() : nullptr;
    if (!parent) return unknown;
    if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(parent)) {
      if (cast->getType().isConstQualified()) return none;  // who casts that away is an escape
    } else if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) {
      const auto* call = parent_as<clang::CXXMemberCallExpr>(unit.ast(), *member);
      return call ? of_method(unit, array, call) : unknown;
    } else if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent)) {
      return of_operator(unit, array, op);
    } else if (!llvm::isa<clang::ParenExpr>(parent)) {
      return unknown;
    }
    at = parent;
  }
}

}  // namespace

ArrayGrowth growth_at(const Unit& unit, const clang::MemberExpr* array, const std::string& message) {
  if (array->getType().isConstQualified()) return none;
  if (!is_part_of(array, message)) return unknown;
  const ArrayGrowth growth = growth_of_mention(unit, array);
  // One line of a macro may stand for many arrays, or for one several times.
  return growth.most_bytes != 0 && array->getMemberLoc().isMacroID() ? unknown : growth;
}

namespace {

/// const Image&, const Image*, std::vector<Image>::const_iterator, a copy
bool only_reads(clang::QualType parameter) {
  if (parameter->isReferenceType()) return parameter.getNonReferenceType().isConstQualified();
  if (message_of(parameter)) return true;
  clang::QualType pointee = pointee_of(parameter);
  if (pointee.isNull()) pointee = pointee_of(first_argument(parameter));  // of an iterator
  return !pointee.isNull() && pointee.isConstQualified();
}

/// They give a part of what they are given, or a place in it, and write nothing.
bool finds(const clang::FunctionDecl* function) {
  static const std::set<std::string> names = {
      "adjacent_find",   "find",        "find_end",    "find_first_of", "find_if",
      "find_if_not",     "lower_bound", "max_element", "min_element",   "minmax_element",
      "partition_point", "search",      "upper_bound"};
  return function->getIdentifier() && names.count(function->getNameAsString()) != 0;
}

}  // namespace

/// What is given nothing but the message and numbers has no other content for it: std::get<0>(pair), std::next(frames.begin(), 2).
bool may_fill(const clang::FunctionDecl* function, unsigned argument) {
  if (argument >= function->getNumParams()) return true;
  if (only_reads(function->getParamDecl(argument)->getType()) || finds(function)) return false;
  for (const clang::ParmVarDecl* parameter : function->parameters())
    if (parameter->getFunctionScopeIndex() != argument && !parameter->getType()->isArithmeticType())
      return true;
  return false;
}

}  // namespace tzc::rewriter
