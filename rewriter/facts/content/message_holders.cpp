// SPDX-License-Identifier: BSD-3-Clause
#include "facts/content/message_holders.h"

#include <set>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/message_type.h"
#include "model/content_flow.h"

namespace tzc::rewriter {
namespace {

constexpr unsigned max_depth = 12;

}  // namespace

/// The operand that an expression merely passes on, without making another object; null: it is a name, a call, or something else.
const clang::Expr* operand_of(const clang::Expr* expr) {
  if (const clang::Expr* operand = converted(expr)) return operand;
  if (const auto* op = llvm::dyn_cast<clang::UnaryOperator>(expr)) return op->getSubExpr();
  if (const auto* element = llvm::dyn_cast<clang::ArraySubscriptExpr>(expr)) return element->getBase();
  if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(expr)) return op->getArg(0);
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
  return made && made->getNumArgs() > 0 ? made->getArg(0) : nullptr;
}

MessageHolders::MessageHolders(const Unit& unit, const FunctionView& view)
    : unit_(unit), view_(view), parts_(unit, view), function_(usr_of(pattern_of(view.function()))) {}

/// A variable of a function has its name in that function only.
std::string MessageHolders::unique(const clang::ValueDecl* decl) const {
  return root_in(function_, parts_.root_of(decl));
}

namespace {

/// const Image& image = Image(other): what lives as long as the reference.
bool is_temporary(const clang::Expr* init) {
  while (const auto* cast = llvm::dyn_cast_or_null<clang::ImplicitCastExpr>(init)) init = cast->getSubExpr();
  if (const auto* full = llvm::dyn_cast_or_null<clang::FullExpr>(init))
    return is_temporary(full->getSubExpr());
  return llvm::isa_and_nonnull<clang::MaterializeTemporaryExpr>(init);
}

/// Messages of its own: Image, std::vector<Image>, a temporary that a reference keeps. What is made from others holds copies of them, and is
/// no second name.
bool is_object(const clang::VarDecl* variable) {
  const clang::QualType type = variable->getType();
  return holds_messages(type.getNonReferenceType()) &&
         (!type->isReferenceType() || is_temporary(variable->getInit()));
}

}  // namespace

/// The range of a loop over it, or what a reference, a pointer or an iterator was made from; null: neither.
const clang::Expr* MessageHolders::leads_to(const clang::VarDecl* variable) const {
  for (const clang::Stmt* stmt : view_.statements())
    if (const auto* loop = llvm::dyn_cast<clang::CXXForRangeStmt>(stmt))
      if (loop->getLoopVariable() == variable) return loop->getRangeInit();
  const bool is_name = variable->isLocalVarDecl() && !variable->isStaticLocal() && !is_object(variable);
  return is_name ? variable->getInit() : nullptr;
}

std::string MessageHolders::of_name(const clang::VarDecl* variable, unsigned depth) const {
  const clang::Expr* const from = leads_to(variable);
  const std::string holder = from ? of(from, depth) : std::string();
  return holder.empty() ? unique(variable) : holder;
}

namespace {

/// std::get<0>(frames): what it gives is part of what it is given.
bool gives_part(const clang::FunctionDecl* function) {
  static const std::set<std::string> names = {"std::get",  "boost::get", "std::begin",
                                              "std::next", "std::prev",  "std::data"};
  return names.count(qualified_name_of(function)) != 0;
}

}  // namespace

std::string MessageHolders::of_call(const clang::CallExpr* call, unsigned depth) const {
  const clang::FunctionDecl* function = call->getDirectCallee();
  if (!function) return {};
  if (call->getNumArgs() > 0 && (passes_through(function) || gives_part(function)))
    return of(call->getArg(0), depth);
  const auto* method = llvm::dyn_cast<clang::CXXMemberCallExpr>(call);
  if (!unit_.declares(function))
    return method ? of(method->getImplicitObjectArgument(), depth) : std::string();
  const MessagePart part = parts_.part_of(call);
  return outlives_functions(part) ? part.substr(0, part.find_first_of("/["))
                                  : result_root(usr_of(pattern_of(function)));
}

std::string MessageHolders::of(const clang::Expr* expr, unsigned depth) const {
  if (depth > max_depth) return {};
  expr = expr->IgnoreParens();
  if (const auto* name = llvm::dyn_cast<clang::DeclRefExpr>(expr)) {
    const auto* binding = llvm::dyn_cast<clang::BindingDecl>(name->getDecl());
    const auto* variable =
        llvm::dyn_cast<clang::VarDecl>(binding ? binding->getDecomposedDecl() : name->getDecl());
    return variable ? of_name(variable, depth + 1) : std::string();
  }
  if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(expr))
    return unit_.source.in_package(member->getMemberDecl()->getLocation()) ? unique(member->getMemberDecl())
                                                                           : of(member->getBase(), depth + 1);
  if (const clang::Expr* operand = operand_of(expr)) return of(operand, depth + 1);
  const auto* call = llvm::dyn_cast<clang::CallExpr>(expr);
  return call ? of_call(call, depth + 1) : std::string();
}

}  // namespace tzc::rewriter
