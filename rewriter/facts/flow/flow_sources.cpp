// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/flow_sources.h"

#include "facts/syntax/calls.h"
#include "facts/syntax/library_advertise.h"
#include "facts/syntax/message_parts.h"

namespace tzc::rewriter {
namespace {

void unite(FlowSources& into, const FlowSources& from) {
  into.entities.insert(into.entities.end(), from.entities.begin(), from.entities.end());
  into.foreign = into.foreign || from.foreign;
}

FlowSources one(const EntityId& entity) {
  FlowSources sources;
  if (!entity.empty()) sources.entities.push_back(entity);
  return sources;
}

FlowSources foreign() {
  FlowSources sources;
  sources.foreign = true;
  return sources;
}

/// Of a function object or pointer, or an override: it may be the package's own, or a library's.
bool is_known_when_run(const clang::CallExpr* call) {
  const clang::FunctionDecl* function = call->getDirectCallee();
  const auto* method = llvm::dyn_cast_or_null<clang::CXXMethodDecl>(function);
  return !function || (method && (method->isVirtual() || method->getOverloadedOperator() == clang::OO_Call));
}

}  // namespace

std::string builder_of(const clang::Expr* value) {
  const clang::CallExpr* call = call_behind(value);
  return call && is_known_when_run(call) ? "a function that is known only when it runs"
                                         : "code outside the package";
}

FlowSources SourceFinder::of_member(const clang::MemberExpr* member) {
  if (message_of(member->getBase()->getType()) ||
      (member->isArrow() && message_of(member->getBase()->getType()->getPointeeType())))
    return of(member->getBase());
  if (llvm::isa<clang::FieldDecl, clang::VarDecl>(member->getMemberDecl())) {
    const EntityId key = entities_.declare(member->getMemberDecl());
    if (!key.empty()) return one(key);
  }
  // it->second: a part of a container's element.
  if (carries(member->getBase()->getType())) return of(member->getBase());
  return foreign();
}

FlowSources SourceFinder::of_method(const clang::CXXMemberCallExpr* call) {
  const clang::CXXMethodDecl* method = call->getMethodDecl();
  if (!method) return foreign();
  const bool advertises = library_advertise_rule(unit_, call) != nullptr;
  if (unit_.declares(method) && !advertises) return one(entities_.declare_result(method));
  if (unit_.rules.find_method(qualified_name_of(method->getParent()), method->getNameAsString(),
                              written_arguments(call)))
    return one(entities_.declare_temporary(call));
  if (advertises) return one(entities_.declare_temporary(call));
  const clang::Expr* object = call->getImplicitObjectArgument();
  if (carries(object->getType())) return of(object);
  return foreign();
}

FlowSources SourceFinder::of_call(const clang::CallExpr* call) {
  if (const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call)) return of_method(method);
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (llvm::isa<clang::CXXOperatorCallExpr>(call) && call->getNumArgs() > 0 && !unit_.declares(function))
    return of(call->getArg(0));
  if (!function) return foreign();
  if (makes_object(call)) return one(entities_.declare_temporary(call));
  if (passes_through(function) || recasts_pointer(unit_, call)) return of(call->getArg(0));
  const bool advertises = library_advertise_rule(unit_, call) || attaches_publisher(unit_, call);
  if (unit_.declares(function) && !advertises) return one(entities_.declare_result(function));
  if (advertises || unit_.rules.find_ported_function(qualified_name_of(function)))
    return one(entities_.declare_temporary(call));
  // std::make_pair, std::get and their like: publishers are handles, a copy is as good. A message would be copied where
  // what is returned does not only lead to it.
  const auto carried = carried_by(call->getType(), unit_.rules);
  const bool is_name = call->isGLValue() || is_iterator(call->getType()) || names_messages(call->getType());
  if (function->isInStdNamespace() && carried && (is_name || carried->role != EntityRole::message)) {
    FlowSources sources = of_arguments({call->getArgs(), call->getNumArgs()});
    if (!sources.entities.empty()) return sources;
  }
  return foreign();
}

FlowSources SourceFinder::of_construction(const clang::CXXConstructExpr* construct) {
  if (llvm::isa<clang::CXXTemporaryObjectExpr>(construct)) return one(entities_.declare_temporary(construct));
  return of_arguments({construct->getArgs(), construct->getNumArgs()});
}

FlowSources SourceFinder::of_arguments(llvm::ArrayRef<const clang::Expr*> arguments) {
  FlowSources sources;
  for (const clang::Expr* argument : arguments)
    if (carries(argument->getType())) unite(sources, of(argument));
  return sources;
}

FlowSources SourceFinder::of_parts(const clang::InitListExpr* list) {
  FlowSources sources;
  for (const clang::Expr* part : list->inits())
    if (carries(part->getType())) unite(sources, of(part));
  return sources;
}

FlowSources SourceFinder::of_cast(const clang::ExplicitCastExpr* cast) {
  const bool from_elsewhere = !carries(cast->getSubExpr()->getType()) && !is_null(unit_, cast->getSubExpr());
  if (from_elsewhere && llvm::isa<clang::CStyleCastExpr>(cast)) return foreign();
  return one(entities_.declare_temporary(cast));
}

FlowSources SourceFinder::of_name(const clang::DeclRefExpr* name) {
  const EntityId entity = entities_.declare(name->getDecl());
  return entity.empty() ? foreign() : one(entity);
}

FlowSources SourceFinder::of_choice(const clang::ConditionalOperator* choice) {
  FlowSources sources = of(choice->getTrueExpr());
  unite(sources, of(choice->getFalseExpr()));
  return sources;
}

/// The part of an expression that its value is taken from; null: it is no such expression.
const clang::Expr* SourceFinder::operand_of(const clang::Expr* expr) const {
  if (const auto* cast = llvm::dyn_cast<clang::ImplicitCastExpr>(expr)) return cast->getSubExpr();
  if (const auto* full = llvm::dyn_cast<clang::FullExpr>(expr)) return full->getSubExpr();
  if (const auto* made = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr)) return made->getSubExpr();
  if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(expr)) return bound->getSubExpr();
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getSubExpr();
  if (const auto* op = llvm::dyn_cast<clang::BinaryOperator>(expr)) {
    if (op->isPtrMemOp()) return nullptr;  // object.*member: nothing shows which
    const bool is_offset = op->getOpcode() == clang::BO_Add && op->getLHS()->getType()->isIntegerType();
    return is_offset || op->getOpcode() == clang::BO_Comma ? op->getRHS() : op->getLHS();
  }
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return element->getBase();
  if (const auto* list = llvm::dyn_cast<clang::CXXStdInitializerListExpr>(expr)) return list->getSubExpr();
  return nullptr;
}

FlowSources SourceFinder::of(const clang::Expr* expr) {
  expr = expr->IgnoreParens();
  if (const clang::Expr* operand = operand_of(expr)) return of(operand);
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) return of_name(name);
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr)) return of_member(member);
  if (const auto* call = llvm::dyn_cast<clang::CallExpr>(expr)) return of_call(call);
  if (const auto* construct = llvm::dyn_cast<clang::CXXConstructExpr>(expr))
    return of_construction(construct);
  if (const auto* list = llvm::dyn_cast<clang::InitListExpr>(expr)) return of_parts(list);
  if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expr)) return of_cast(cast);
  if (llvm::isa<clang::CXXNewExpr>(expr)) return one(entities_.declare_temporary(expr));
  if (const auto* choice = llvm::dyn_cast<clang::ConditionalOperator>(expr)) return of_choice(choice);
  const bool empty =
      llvm::isa<clang::CXXDefaultArgExpr, clang::CXXScalarValueInitExpr, clang::ImplicitValueInitExpr>(expr);
  return carries(expr->getType()) && !empty ? foreign() : FlowSources();
}

}  // namespace tzc::rewriter
