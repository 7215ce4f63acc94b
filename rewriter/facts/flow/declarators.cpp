// SPDX-License-Identifier: BSD-3-Clause
#include "facts/flow/declarators.h"

#include <clang/AST/TypeLoc.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>

#include "facts/syntax/ast_walk.h"

namespace tzc::rewriter {
namespace {

/// The declarator in front of `decl` among declarations that begin at the same word.
template <class Range>
const clang::DeclaratorDecl* before_in(const Range& declarations, const clang::DeclaratorDecl* decl) {
  const clang::DeclaratorDecl* left = nullptr;
  for (const clang::Decl* one : declarations) {
    if (one == decl) return left;
    const auto* declarator = llvm::dyn_cast<clang::DeclaratorDecl>(one);
    const bool together = declarator && declarator->getBeginLoc() == decl->getBeginLoc();
    left = together ? declarator : nullptr;
  }
  return nullptr;
}

const clang::DeclaratorDecl* left_of(const Unit& unit, const clang::DeclaratorDecl* decl) {
  if (decl->getDeclContext()->isFunctionOrMethod()) {
    const auto* statement = parent_as<clang::DeclStmt>(unit.ast(), *decl);
    const bool in_block = statement && parent_as<clang::CompoundStmt>(unit.ast(), *statement);
    return in_block ? before_in(statement->decls(), decl) : nullptr;
  }
  return before_in(decl->getDeclContext()->decls(), decl);
}

/// The type that all declarators of the declaration share: without *, & and [].
clang::TypeLoc shared_type(const clang::DeclaratorDecl* decl) {
  clang::TypeLoc type = decl->getTypeSourceInfo()->getTypeLoc();
  for (;;) {
    clang::TypeLoc inner;
    if (const auto pointer = type.getAs<clang::PointerTypeLoc>()) inner = pointer.getPointeeLoc();
    if (const auto reference = type.getAs<clang::ReferenceTypeLoc>()) inner = reference.getPointeeLoc();
    if (const auto array = type.getAs<clang::ArrayTypeLoc>()) inner = array.getElementLoc();
    if (inner.isNull()) return type;
    type = inner;
  }
}

bool is_only(const std::string& text, const char* characters) {
  return text.find_first_not_of(characters) == std::string::npos;
}

Place between(const Place& from, const Place& to) {
  Place place = from;
  place.begin = from.end;
  place.end = to.begin;
  return place;
}

/// The words that the declarators share; none: something else stands among them.
std::optional<Place> shared_words(const Unit& unit, const clang::DeclaratorDecl* first) {
  const std::optional<Place> words =
      unit.source.place({first->getBeginLoc(), shared_type(first).getEndLoc()});
  const std::optional<Place> name = unit.source.place(first->getLocation());
  if (!words || !name || words->file != name->file || words->end > name->begin) return {};
  const std::string text = unit.source.text(*words);
  const bool plain = text.find_first_of("\n$") == std::string::npos && text.find("/*") == std::string::npos;
  return plain && is_only(unit.source.text(between(*words, *name)), " \t*&") ? words : std::nullopt;
}

std::optional<clang::Token> next_token(const Unit& unit, clang::SourceLocation after) {
  if (after.isMacroID()) return {};
  const auto token = clang::Lexer::findNextToken(after, unit.source.manager(), unit.ast().getLangOpts());
  return token ? std::optional<clang::Token>(*token) : std::nullopt;
}

/// From the comma to the declarator.
std::optional<Place> gap_behind(const Unit& unit, const clang::DeclaratorDecl* left) {
  const auto comma = next_token(unit, left->getEndLoc());
  if (!comma || !comma->is(clang::tok::comma)) return {};
  const auto right = next_token(unit, comma->getLocation());
  const auto from = unit.source.before(comma->getLocation());
  const auto to = right ? unit.source.before(right->getLocation()) : std::nullopt;
  return from && to ? std::optional(between(*from, *to)) : std::nullopt;
}

}  // namespace

std::optional<SharedDeclaration> shared_declaration(const Unit& unit, const clang::DeclaratorDecl* decl) {
  const clang::DeclaratorDecl* left = left_of(unit, decl);
  if (!left || !left->getTypeSourceInfo() || left->getPreviousDecl() != nullptr) return {};
  const clang::DeclaratorDecl* first = left;
  while (const clang::DeclaratorDecl* before = left_of(unit, first)) first = before;
  const std::optional<Place> words = shared_words(unit, first);
  const std::optional<Place> gap = words ? gap_behind(unit, left) : std::nullopt;
  if (!gap || gap->file != words->file) return {};
  const std::string text = unit.source.text(*gap).substr(1);
  const std::string indent = unit.source.indent(*words);
  const std::size_t newline = text.rfind('\n');
  if (newline != std::string::npos)
    return SharedDeclaration{left, *words, *gap, ";" + text.substr(0, newline + 1) + indent, " "};
  if (!is_only(text, " \t")) return {};
  return SharedDeclaration{left, *words, *gap, ";\n" + indent, " "};
}

std::string with_changes(const Place& piece, std::string text, const std::vector<Change>& changes) {
  std::vector<const Change*> inside;
  for (const Change& change : changes)
    if (change.where.file == piece.file && change.where.begin >= piece.begin && change.where.end <= piece.end)
      inside.push_back(&change);
  std::sort(inside.begin(), inside.end(),
            [](const Change* a, const Change* b) { return a->where.begin > b->where.begin; });
  for (const Change* change : inside)
    text.replace(change->where.begin - piece.begin, change->where.end - change->where.begin, change->text);
  return text;
}

}  // namespace tzc::rewriter
