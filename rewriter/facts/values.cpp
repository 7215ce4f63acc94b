// SPDX-License-Identifier: BSD-3-Clause
// Where the value of an expression comes from.
#include "facts/advertise_sites.h"

namespace tzc::rewriter {
namespace {

void unite(Sources& into, const Sources& from) {
  into.keys.insert(into.keys.end(), from.keys.begin(), from.keys.end());
  into.foreign = into.foreign || from.foreign;
}

Sources one(const Key& key) {
  Sources sources;
  if (!key.empty()) sources.keys.push_back(key);
  return sources;
}

Sources foreign() {
  Sources sources;
  sources.foreign = true;
  return sources;
}

Sources of_member(Unit& unit, const clang::MemberExpr* member) {
  if (message_of(member->getBase()->getType()) ||
      (member->isArrow() && message_of(member->getBase()->getType()->getPointeeType())))
    return sources_of(unit, member->getBase());
  if (llvm::isa<clang::FieldDecl, clang::VarDecl>(member->getMemberDecl())) {
    const Key key = declare(unit, member->getMemberDecl());
    if (!key.empty()) return one(key);
  }
  // it->second: a part of a container's element.
  if (carried_by(member->getBase()->getType(), unit.rules)) return sources_of(unit, member->getBase());
  return foreign();
}

Sources of_method(Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method) return foreign();
  if (is_package_function(unit, method)) return one(declare_result(unit, method));
  if (unit.rules.find_method(qualified_name_of(method->getParent()), method->getNameAsString(),
                             written_arguments(call)))
    return one(declare_temporary(unit, call));
  if (library_advertise_rule(unit, call)) return one(declare_temporary(unit, call));
  const clang::Expr* object = call->getImplicitObjectArgument();
  if (carried_by(object->getType(), unit.rules)) return sources_of(unit, object);
  return foreign();
}

Sources of_call(Unit& unit, const clang::CallExpr* call) {
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) return of_method(unit, method);
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) && call->getNumArgs() > 0 &&
      !is_package_function(unit, function))
    return sources_of(unit, call->getArg(0));
  if (!function) return foreign();
  if (makes_object(call)) return one(declare_temporary(unit, call));
  if (passes_through(function)) return sources_of(unit, call->getArg(0));
  if (is_package_function(unit, function)) return one(declare_result(unit, function));
  const bool advertises = library_advertise_rule(unit, call) || attaches_publisher(unit, call);
  if (advertises || unit.rules.find_ported_function(qualified_name_of(function)))
    return one(declare_temporary(unit, call));
  return foreign();
}

Sources of_construction(Unit& unit, const clang::CXXConstructExpr* construct) {
  if (llvm::isa<clang::CXXTemporaryObjectExpr>(construct)) return one(declare_temporary(unit, construct));
  Sources sources;
  if (construct->getNumArgs() > 0 && carried_by(construct->getArg(0)->getType(), unit.rules))
    unite(sources, sources_of(unit, construct->getArg(0)));
  return sources;
}

Sources of_parts(Unit& unit, const clang::InitListExpr* list) {
  Sources sources;
  for (const clang::Expr* part : list->inits())
    if (carried_by(part->getType(), unit.rules)) unite(sources, sources_of(unit, part));
  return sources;
}

Sources of_cast(Unit& unit, const clang::ExplicitCastExpr* cast) {
  const bool from_nothing = !carried_by(cast->getSubExpr()->getType(), unit.rules);
  if (from_nothing && llvm::isa<clang::CStyleCastExpr>(cast)) return foreign();
  return one(declare_temporary(unit, cast));
}

}  // namespace

unsigned written_arguments(const clang::CallExpr* call) {
  unsigned count = 0;
  for (const clang::Expr* argument : call->arguments())
    if (!llvm::isa<clang::CXXDefaultArgExpr>(argument)) ++count;
  return count;
}

bool passes_through(const clang::FunctionDecl* function) {
  static const std::set<std::string> names = {
      "std::move",      "std::forward", "std::ref",    "std::cref",      "boost::move",
      "boost::forward", "boost::ref",   "boost::cref", "std::addressof", "boost::addressof"};
  return function && names.count(qualified_name_of(function)) != 0;
}

bool makes_object(const clang::CallExpr* call) {
  static const std::set<std::string> names = {"boost::make_shared", "std::make_shared", "std::make_unique",
                                              "boost::make_unique"};
  const clang::FunctionDecl* function = call->getDirectCallee();
  return function && names.count(qualified_name_of(function)) != 0;
}

Sources sources_of(Unit& unit, const clang::Expr* expr) {
  expr = expr->IgnoreParens();
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(expr))
    return sources_of(unit, cast->getSubExpr());
  if (const auto* full = llvm::dyn_cast<clang::FullExpr>(expr)) return sources_of(unit, full->getSubExpr());
  if (const auto* temporary = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr))
    return sources_of(unit, temporary->getSubExpr());
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(expr))
    return sources_of(unit, bound->getSubExpr());
  if (const auto* reference = llvm::dyn_cast<clang::DeclRefExpr>(expr)) {
    const Key key = declare(unit, reference->getDecl());
    return key.empty() ? foreign() : one(key);
  }
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return of_member(unit, member);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return of_call(unit, call);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(expr))
    return of_construction(unit, construct);
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expr)) return of_parts(unit, list);
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expr)) return of_cast(unit, cast);
  if (llvm::isa<clang::CXXNewExpr>(expr)) return one(declare_temporary(unit, expr));
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return sources_of(unit, op->getSubExpr());
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(expr)) return sources_of(unit, op->getLHS());
  if (const auto* subscript = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr))
    return sources_of(unit, subscript->getBase());
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expr)) {
    Sources sources = sources_of(unit, choice->getTrueExpr());
    unite(sources, sources_of(unit, choice->getFalseExpr()));
    return sources;
  }
  return carried_by(expr->getType(), unit.rules) && !llvm::isa<clang::CXXDefaultArgExpr>(expr) &&
                 !llvm::isa<clang::CXXScalarValueInitExpr>(expr) &&
                 !llvm::isa<clang::ImplicitValueInitExpr>(expr)
             ? foreign()
             : Sources();
}

}  // namespace tzc::rewriter
