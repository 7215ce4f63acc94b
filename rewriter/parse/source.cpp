// SPDX-License-Identifier: BSD-3-Clause
#include "parse/source.h"

#include <clang/Lex/Lexer.h>
#include <llvm/Support/Path.h>

#include <cstdlib>

namespace tzc::rewriter {
namespace {

std::string canonical(llvm::StringRef path) {
  char* real = ::realpath(path.str().c_str(), nullptr);
  if (!real) return path.str();
  std::string result = real;
  std::free(real);
  return result;
}

/// What compilers take for white space, and leave out between a backslash and the end of its line.
constexpr llvm::StringRef blanks("\0 \t\v\f", 5);

/// Whether the rest of a line is a comment that ends with it. One whose line ends in a backslash, or in the trigraph that stands for it,
/// goes on in the next line: what is inserted between them would become part of it, and that line would become code. Clang ends
/// a line at a carriage return alone, gcc does not.
bool is_whole_comment(llvm::StringRef rest) {
  if (rest.contains('\r') || rest.ends_with("\\") || rest.ends_with("\?\?/")) return false;
  return rest.starts_with("//") || (rest.starts_with("/*") && rest.find("*/", 2) == rest.size() - 2);
}

}  // namespace

Source::Source(clang::ASTContext& ast, FolderSet packages)
    : ast_(ast), manager_(ast.getSourceManager()), packages_(std::move(packages)) {}

const std::string& Source::file_of(clang::SourceLocation location) const {
  const clang::FileID id = manager_.getFileID(manager_.getExpansionLoc(location));
  auto known = files_.find(id);
  if (known != files_.end()) return known->second;
  std::string path;
  if (const clang::OptionalFileEntryRef entry = manager_.getFileEntryRefForID(id)) {
    const llvm::StringRef real = entry->getFileEntry().tryGetRealPathName();
    path = canonical(real.empty() ? entry->getName() : real);
    ids_[path] = id;
  }
  return files_.emplace(id, path).first->second;
}

bool Source::in_package(clang::SourceLocation location) const {
  if (location.isInvalid()) return false;
  return packages_.hold(file_of(location));
}

Place Source::make(clang::SourceLocation begin, unsigned length) const {
  Place place;
  place.file = file_of(begin);
  place.begin = manager_.getFileOffset(begin);
  place.end = place.begin + length;
  place.line = manager_.getSpellingLineNumber(begin);
  place.column = manager_.getSpellingColumnNumber(begin);
  return place;
}

std::optional<Place> Source::place(clang::SourceRange tokens) const {
  const clang::CharSourceRange range = clang::Lexer::makeFileCharRange(
      clang::CharSourceRange::getTokenRange(tokens), manager_, ast_.getLangOpts());
  if (range.isInvalid() || !in_package(range.getBegin())) return {};
  // A range that a macro's body spells maps to the macro's name in the file, which must not be edited.
  if (tokens.getBegin().isMacroID() && !manager_.isMacroArgExpansion(tokens.getBegin())) return {};
  const unsigned begin = manager_.getFileOffset(range.getBegin());
  const unsigned end = manager_.getFileOffset(range.getEnd());
  return end < begin ? std::nullopt : std::optional(make(range.getBegin(), end - begin));
}

std::optional<Place> Source::before(clang::SourceLocation location) const {
  std::optional<Place> result = place(location);
  if (result) result->end = result->begin;
  return result;
}

Place Source::where(clang::SourceLocation location) const {
  return make(manager_.getFileLoc(location), 0);
}

std::vector<unsigned> Source::offsets_in_macros(clang::SourceLocation location) const {
  std::vector<unsigned> offsets;
  for (; location.isMacroID(); location = manager_.getImmediateMacroCallerLoc(location)) {
    const clang::SourceLocation spelled = manager_.getSpellingLoc(location);
    // A name that is pasted together (Proxy ## id) has its text behind all that was pasted before; its caller is where its first half stands.
    if (!manager_.isWrittenInScratchSpace(spelled)) offsets.push_back(manager_.getFileOffset(spelled));
  }
  return offsets;
}

std::string Source::text(clang::SourceRange tokens) const {
  const clang::CharSourceRange range = clang::Lexer::makeFileCharRange(
      clang::CharSourceRange::getTokenRange(tokens), manager_, ast_.getLangOpts());
  return clang::Lexer::getSourceText(range, manager_, ast_.getLangOpts()).str();
}

llvm::StringRef Source::buffer(const Place& place) const {
  const auto id = ids_.find(place.file);
  return id == ids_.end() ? llvm::StringRef() : manager_.getBufferData(id->second);
}

std::string Source::text(const Place& place) const {
  return buffer(place).substr(place.begin, place.end - place.begin).str();
}

std::optional<Place> Source::behind(clang::SourceRange tokens) const {
  std::optional<Place> range = place(tokens);
  if (!range) return {};
  const llvm::StringRef content = buffer(*range);
  std::size_t end = range->end;
  if (end == 0 || content[end - 1] != ';') {
    end = content.find_first_not_of(" \t\r\n", end);
    if (end == llvm::StringRef::npos || content[end] != ';') return {};
    ++end;
  }
  range->begin = range->end = static_cast<unsigned>(end);
  return range;
}

std::optional<Place> Source::line_end(const Place& place) const {
  llvm::StringRef line = buffer(place).substr(place.end).take_until([](char c) { return c == '\n'; });
  line.consume_back("\r");
  const llvm::StringRef rest = line.trim(blanks);
  if (!rest.empty() && !is_whole_comment(rest)) return {};
  Place end = place;
  end.begin = end.end = place.end + static_cast<unsigned>(line.rtrim(" \t").size());
  return end;
}

std::string Source::indent(const Place& place) const {
  const llvm::StringRef head = buffer(place).take_front(place.begin);
  const std::size_t newline = head.rfind('\n');
  const llvm::StringRef line = newline == llvm::StringRef::npos ? head : head.substr(newline + 1);
  return line.take_while([](char c) { return c == ' ' || c == '\t'; }).str();
}

bool Source::starts_line(const Place& place) const {
  const llvm::StringRef head = buffer(place).take_front(place.begin).rtrim(" \t");
  return head.empty() || head.back() == '\n';
}

}  // namespace tzc::rewriter
