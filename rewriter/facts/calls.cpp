// SPDX-License-Identifier: BSD-3-Clause
#include <clang/AST/ParentMapContext.h>

#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

const clang::MemberExpr* callee_of(const clang::CXXMemberCallExpr* call) {
  return llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
}

/// Comments between the object and the arguments stay.
std::string comments_in(const std::string& text) {
  std::string comments;
  for (std::size_t at = text.find("/*"); at != std::string::npos; at = text.find("/*", at + 2))
    comments += " " + text.substr(at, text.find("*/", at) + 2 - at);
  return comments;
}

Place span(const Place& from, unsigned begin, unsigned end) {
  Place place = from;
  place.begin = begin;
  place.end = end;
  return place;
}

/// The parenthesis that opens the arguments, behind the function's name.
unsigned first_paren(Unit& unit, const Place& call, unsigned from) {
  const std::string text = unit.source.text(span(call, from, call.end));
  return from + static_cast<unsigned>(text.find('('));
}

}  // namespace

Receiver receiver_of(const clang::CXXMemberCallExpr* call) {
  const clang::MemberExpr* callee = callee_of(call);
  if (!callee) return {};
  const clang::Expr* base = callee->getBase()->IgnoreParenImpCasts();
  if (llvm::isa<clang::CXXThisExpr>(base)) return {base, true};
  const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(base);
  if (op && op->getOperator() == clang::OO_Arrow) return {op->getArg(0)->IgnoreImpCasts(), true};
  return {callee->getBase()->IgnoreImpCasts(), callee->isArrow()};
}

std::string written_template_arguments(Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::MemberExpr* callee = callee_of(call);
  if (!callee || !callee->hasExplicitTemplateArgs() || callee->getNumTemplateArgs() == 0) return "";
  const clang::SourceRange range(
      callee->getTemplateArgs()[0].getSourceRange().getBegin(),
      callee->getTemplateArgs()[callee->getNumTemplateArgs() - 1].getSourceRange().getEnd());
  return unit.source.text(range);
}

std::vector<Change> receiver_first(Unit& unit, const clang::CXXMemberCallExpr* call, const std::string& to,
                                   const char* rule, const char* header, const std::string& last) {
  const Receiver receiver = receiver_of(call);
  if (!receiver.expr) return {};
  const auto* self = llvm::dyn_cast<clang::CXXThisExpr>(receiver.expr);
  const std::optional<Place> whole = unit.source.place(call->getSourceRange());
  if (!whole) return {};
  const bool implicit = self && self->isImplicit();
  const std::optional<Place> object =
      implicit ? unit.source.before(call->getBeginLoc()) : unit.source.place(receiver.expr->getSourceRange());
  if (!object) return {};
  const unsigned count = written_arguments(call);
  const std::optional<Place> first = count > 0 ? unit.source.place(call->getArg(0)->getSourceRange())
                                               : unit.source.before(call->getRParenLoc());
  if (!first || first->begin < object->end || object->begin != whole->begin) return {};
  const std::optional<Place> name = unit.source.place(callee_of(call)->getSourceRange());
  if (!name) return {};
  const unsigned open_paren = first_paren(unit, *whole, name->end);
  const Place between = span(*whole, object->end, open_paren + 1);
  std::string separator = (count > 0 || !last.empty() ? "," : "") + comments_in(unit.source.text(between));
  const std::string behind = unit.source.text(span(*whole, open_paren + 1, open_paren + 2));
  if (!separator.empty() && count > 0 && behind != " " && behind != "\n" && behind != "\r") separator += " ";
  const std::string open = to + "(" + (receiver.pointer ? "*" : "") + (implicit ? "this" : "");
  return {{span(*whole, object->begin, object->begin), open, rule, {header}},
          {between, separator + (last.empty() ? "" : (count > 0 ? "" : " ") + last), rule, {}}};
}

std::optional<std::string> constant_string(const clang::Expr* expr) {
  for (;;) {
    expr = expr->IgnoreParenImpCasts();
    if (const auto* literal = llvm::dyn_cast<clang::StringLiteral>(expr)) return literal->getString().str();
    if (const auto* full = llvm::dyn_cast<clang::FullExpr>(expr)) {
      expr = full->getSubExpr();
    } else if (const auto* temporary = llvm::dyn_cast<clang::MaterializeTemporaryExpr>(expr)) {
      expr = temporary->getSubExpr();
    } else if (const auto* bound = llvm::dyn_cast<clang::CXXBindTemporaryExpr>(expr)) {
      expr = bound->getSubExpr();
    } else if (const auto* cast = llvm::dyn_cast<clang::ExplicitCastExpr>(expr)) {
      expr = cast->getSubExpr();
    } else if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(expr);
               made && made->getNumArgs() > 0) {
      expr = made->getArg(0);
    } else {
      return {};
    }
  }
}

bool serves_plain_field(Unit& unit, const clang::Expr* cast) {
  const clang::Expr* at = cast;
  for (;;) {
    const auto parents = unit.ast().getParents(*at);
    const auto* parent = parents.empty() ? nullptr : parents[0].get<clang::Expr>();
    if (!parent) return false;
    if (const auto* member = llvm::dyn_cast<clang::MemberExpr>(parent)) {
      const bool field = llvm::isa<clang::FieldDecl>(member->getMemberDecl());
      if (field) return !is_data_array(member->getType()) && !carried_by(member->getType(), unit.rules);
    } else if (const auto* op = llvm::dyn_cast<clang::CXXOperatorCallExpr>(parent)) {
      if (op->getOperator() != clang::OO_Arrow && op->getOperator() != clang::OO_Star) return false;
    } else if (!llvm::isa<clang::ParenExpr, clang::ImplicitCastExpr, clang::FullExpr,
                          clang::MaterializeTemporaryExpr, clang::CXXBindTemporaryExpr, clang::UnaryOperator>(
                   parent)) {
      return false;
    }
    at = parent;
  }
}

void check_const_cast(Unit& unit, const clang::ExplicitCastExpr* cast) {
  const clang::Expr* from = cast->getSubExpr();
  if (!llvm::isa<clang::CXXConstCastExpr>(cast) || !carried_by(from->getType(), unit.rules)) return;
  if (serves_plain_field(unit, cast)) return;
  for (const Key& key : sources_of(unit, from).keys)
    add_obstacle(unit, key, codes::TZC2002, "const is cast away from it", cast->getBeginLoc());
}

std::string function_name_around(Unit& unit, const clang::Stmt& stmt) {
  const clang::FunctionDecl* function = function_around(unit, stmt);
  while (function) {
    const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(function);
    if (!method || !method->getParent()->isLambda()) break;
    const auto* outer = llvm::dyn_cast<clang::FunctionDecl>(method->getParent()->getDeclContext());
    if (!outer) break;
    function = outer;
  }
  return function ? qualified_name_of(function) : "";
}

}  // namespace tzc::rewriter
