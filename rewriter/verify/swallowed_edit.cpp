// SPDX-License-Identifier: BSD-3-Clause
#include "verify/swallowed_edit.h"

#include <clang/Basic/LangOptions.h>
#include <clang/Basic/LangStandard.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <vector>

#include "edits/apply.h"

namespace tzc::rewriter {
namespace {

/// A word, a number, a literal, or one character of punctuation: `>` behind `>` is the same token as in `> >`.
struct CodeToken {
  std::string text;
  std::size_t begin = 0, end = 0;  ///< in the original; of an edit's token: what the edit replaces
  bool in_directive = false;
  bool is_same(const CodeToken& other) const {
    return text == other.text && in_directive == other.in_directive;
  }
};
using CodeTokens = std::vector<CodeToken>;

clang::LangOptions any_cxx() {
  clang::LangOptions language;
  std::vector<std::string> no_includes;
  clang::LangOptions::setLangDefaults(language, clang::Language::CXX, llvm::Triple(), no_includes,
                                      clang::LangStandard::lang_cxx17);
  return language;
}

bool is_one_token(const clang::Token& token) {
  return token.is(clang::tok::raw_identifier) || token.isLiteral() || token.is(clang::tok::unknown);
}

CodeTokens tokens_of(const std::string& text) {
  static const clang::LangOptions language = any_cxx();
  clang::Lexer lexer(clang::SourceLocation(), language, text.data(), text.data(), text.data() + text.size());
  CodeTokens tokens;
  clang::Token token;
  bool in_directive = false;
  for (bool is_last = false; !is_last;) {
    is_last = lexer.LexFromRawLexer(token);
    if (token.is(clang::tok::eof)) break;
    if (token.isAtStartOfLine()) in_directive = token.is(clang::tok::hash);
    const std::size_t end = static_cast<std::size_t>(lexer.getBufferLocation() - text.data());
    const std::size_t begin = end - token.getLength();
    const std::size_t step = is_one_token(token) ? end - begin : 1;
    for (std::size_t at = begin; at < end; at += step)
      tokens.push_back({text.substr(at, step), at, at + step, in_directive});
  }
  return tokens;
}

/// The tokens that the edit writes. What it writes into a directive is part of that directive.
CodeTokens written_by(const Edit& edit, bool replaces_directive) {
  CodeTokens tokens = tokens_of(edit.text);
  for (CodeToken& token : tokens) {
    token.begin = edit.offset;
    token.end = edit.offset + edit.length;
    token.in_directive |= replaces_directive;
  }
  return tokens;
}

CodeTokens meant(const std::string& original, const Edits& edits) {
  const CodeTokens before = tokens_of(original);
  CodeTokens all;
  auto next = before.begin();
  for (const Edit& edit : edits) {
    for (; next != before.end() && next->end <= edit.offset; ++next) all.push_back(*next);
    const std::size_t end = edit.offset + edit.length;
    const bool replaces_directive = next != before.end() && next->begin < end && next->in_directive;
    const CodeTokens written = written_by(edit, replaces_directive);
    all.insert(all.end(), written.begin(), written.end());
    while (next != before.end() && next->end <= end) ++next;
  }
  all.insert(all.end(), next, before.end());
  return all;
}

}  // namespace

std::optional<Edit> swallowed_edit(const std::string& original, const Edits& edits,
                                   const std::string& edited) {
  const Edits ordered = in_order(edits);
  const CodeTokens wanted = meant(original, ordered), found = tokens_of(edited);
  const auto [at, other] = std::mismatch(wanted.begin(), wanted.end(), found.begin(), found.end(),
                                         [](const CodeToken& a, const CodeToken& b) { return a.is_same(b); });
  if ((at == wanted.end() && other == found.end()) || ordered.empty()) return std::nullopt;
  const std::size_t place = at == wanted.end() ? original.size() : at->begin;
  const auto behind =
      std::upper_bound(ordered.begin(), ordered.end(), place,
                       [](std::size_t offset, const Edit& edit) { return offset < edit.offset; });
  return behind == ordered.begin() ? *behind : *std::prev(behind);
}

}  // namespace tzc::rewriter
