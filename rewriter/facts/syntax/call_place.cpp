// SPDX-License-Identifier: BSD-3-Clause
#include "facts/syntax/call_place.h"

#include <clang/Lex/Lexer.h>

#include "facts/syntax/ast_walk.h"
#include "facts/syntax/calls.h"

namespace tzc::rewriter {
namespace {

const clang::MemberExpr* callee_of(const clang::CXXMemberCallExpr* call) {
  return llvm::dyn_cast<clang::MemberExpr>(call->getCallee()->IgnoreParens());
}

/// In a file, and not by a macro. Half of a >> has no location in a file, but is spelled where it stands.
bool is_written(const Unit& unit, clang::SourceLocation location) {
  const clang::SourceManager& manager = unit.source.manager();
  return location.isFileID() || manager.getSpellingLoc(location) == manager.getExpansionLoc(location);
}

bool is_written(const Unit& unit, clang::SourceRange tokens) {
  return is_written(unit, tokens.getBegin()) && is_written(unit, tokens.getEnd());
}

bool has_type_arguments(const clang::MemberExpr* callee) {
  return callee->hasExplicitTemplateArgs() && callee->getNumTemplateArgs() != 0;
}

/// The name with its brackets. What stands between them may come from a macro that writes nothing else.
bool is_name_written(const Unit& unit, const clang::CXXMemberCallExpr* call,
                     const clang::MemberExpr* callee) {
  if (!is_written(unit, callee->getMemberLoc()) || !is_written(unit, callee->getEndLoc())) return false;
  return !has_type_arguments(callee) ||
         (is_written(unit, callee->getLAngleLoc()) && !written_template_arguments(unit, call).empty());
}

/// A call that is a macro's argument stands in the file, too.
bool is_macro_argument(const Unit& unit, const clang::CallExpr* call) {
  const clang::SourceLocation end = call->getRParenLoc();
  return !is_written(unit, end) && unit.source.manager().isMacroArgExpansion(end);
}

/// The parenthesis behind a name. None: something else stands there, as the name of a macro.
std::optional<unsigned> paren_behind(const Unit& unit, clang::SourceLocation name) {
  const clang::SourceManager& manager = unit.source.manager();
  const auto token = clang::Lexer::findNextToken(manager.getFileLoc(name), manager, unit.ast().getLangOpts());
  if (!token || !token->is(clang::tok::l_paren)) return {};
  return unit.offset(token->getLocation());
}

std::optional<Place> object_place(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::Expr* object = receiver_of(call).expr;
  const auto* self = llvm::dyn_cast<clang::CXXThisExpr>(object);
  const bool is_implied = self && self->isImplicit();
  return is_implied ? unit.source.before(call->getBeginLoc()) : unit.source.place(object->getSourceRange());
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

}  // namespace

void set_place(SiteFact& site, const Unit& unit, const clang::Expr* call) {
  site.where = unit.source.where(call->getExprLoc());
  site.in_macros = unit.source.offsets_in_macros(call->getExprLoc());
  site.function = enclosing_function_name(unit.ast(), *call);
}

std::optional<CallPlace> call_place(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::MemberExpr* callee = callee_of(call);
  if (!callee) return {};
  const bool is_written_out = is_written(unit, call->getRParenLoc()) && is_name_written(unit, call, callee);
  if (!is_written_out && !is_macro_argument(unit, call)) return {};
  const std::optional<Place> whole = unit.source.place(call->getSourceRange());
  const std::optional<Place> object = object_place(unit, call);
  const std::optional<Place> name = unit.source.place(callee->getSourceRange());
  const std::optional<unsigned> paren = paren_behind(unit, callee->getEndLoc());
  if (!whole || !object || !name || !paren || object->begin != whole->begin) return {};
  CallPlace place{*object, *whole};
  place.head.begin = object->end;
  place.head.end = *paren + 1;
  return place;
}

std::optional<Place> argument_place(const Unit& unit, const clang::CallExpr* call, unsigned index) {
  const clang::SourceRange tokens = call->getArg(index)->getSourceRange();
  if (is_macro_argument(unit, call)) return unit.source.place(tokens);
  const clang::SourceManager& manager = unit.source.manager();
  const clang::LangOptions& language = unit.ast().getLangOpts();
  clang::SourceLocation begin = tokens.getBegin(), end = tokens.getEnd();
  if (begin.isMacroID() && !clang::Lexer::isAtStartOfMacroExpansion(begin, manager, language, &begin))
    return {};
  if (end.isMacroID() && !clang::Lexer::isAtEndOfMacroExpansion(end, manager, language, &end)) return {};
  return unit.source.place({begin, end});
}

bool is_type_by_macro(const Unit& unit, const clang::CXXMemberCallExpr* call) {
  const clang::MemberExpr* callee = callee_of(call);
  return callee && has_type_arguments(callee) && !is_macro_argument(unit, call) &&
         !is_written(unit, callee->getTemplateArgs()[0].getSourceRange());
}

std::string macro_reason(const Unit& unit, const clang::CXXMemberCallExpr* call, const std::string& name) {
  const bool arguments_only = call_place(unit, call) && !is_macro_argument(unit, call);
  return arguments_only ? "a macro reaches across the arguments" : name + " comes from a macro";
}

std::vector<Change> receiver_first(const Unit& unit, const clang::CXXMemberCallExpr* call,
                                   const Callee& callee, const std::string& last) {
  const Receiver receiver = receiver_of(call);
  const std::optional<CallPlace> place = call_place(unit, call);
  if (!receiver.expr || !place) return {};
  const Place &object = place->object, &head = place->head;
  const unsigned count = written_arguments(call);
  const std::optional<Place> first = count > 0 ? argument_place(unit, call, 0) : head;
  if (!first || first->begin < object.end) return {};
  const bool implicit = object.begin == object.end;
  std::string separator = (count > 0 || !last.empty() ? "," : "") + comments_in(unit.source.text(head));
  const std::string behind = unit.source.text(span(head, head.end, head.end + 1));
  if (!separator.empty() && count > 0 && behind != " " && behind != "\n" && behind != "\r") separator += " ";
  const std::string open = callee.to + "(" + (receiver.pointer ? "*" : "") + (implicit ? "this" : "");
  return {{span(object, object.begin, object.begin), open, callee.rule, {callee.header}},
          {head, separator + (last.empty() ? "" : (count > 0 ? "" : " ") + last), callee.rule, {}}};
}

std::vector<Change> receiver_back(const Unit& unit, const clang::CallExpr* call, const Callee& method) {
  const std::optional<Place> whole = unit.source.place(call->getSourceRange());
  const auto object = argument_place(unit, call, 0), first = argument_place(unit, call, 1);
  if (!whole || !object || !first) return {};
  const clang::Expr* expr = call->getArg(0)->IgnoreImplicit();
  const bool is_postfix =
      llvm::isa<clang::DeclRefExpr, clang::MemberExpr, clang::ParenExpr, clang::ArraySubscriptExpr>(expr) ||
      unit.source.text(*object).back() == ']';
  return {{span(*whole, whole->begin, object->begin), is_postfix ? "" : "(", method.rule, {}},
          {span(*whole, object->end, first->begin),
           std::string(is_postfix ? "." : ").") + method.to + "(",
           method.rule,
           {}}};
}

}  // namespace tzc::rewriter
