// SPDX-License-Identifier: BSD-3-Clause
#include "parse/note_preprocessing.h"

#include <clang/Basic/FileEntry.h>
#include <clang/Lex/MacroArgs.h>
#include <clang/Lex/MacroInfo.h>
#include <clang/Lex/PPCallbacks.h>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "edits/files.h"

namespace tzc::rewriter {
namespace {

/// Files have another ID each time that they are read.
class FilePaths {
 public:
  explicit FilePaths(const clang::SourceManager& manager) : manager_(manager) {}

  const std::string& of(clang::FileID file) {
    const auto [known, is_new] = paths_.emplace(file, "");
    const auto entry = is_new ? manager_.getFileEntryRefForID(file) : clang::OptionalFileEntryRef();
    if (entry) known->second = canonical_path(entry->getFileEntry().tryGetRealPathName().str());
    return known->second;
  }

 private:
  const clang::SourceManager& manager_;
  std::map<clang::FileID, std::string> paths_;
};

/// Clang announces each directive that it looks at, and then what it skips behind it: behind the others it compiles.
class Branches : public clang::PPCallbacks {
 public:
  Branches(const clang::SourceManager& manager, PreprocessorNotes& notes)
      : manager_(manager), paths_(manager), notes_(notes) {}

  void If(clang::SourceLocation at, clang::SourceRange, ConditionValueKind) override { count(at, 1); }
  void Ifdef(clang::SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override {
    count(at, 1);
  }
  void Ifndef(clang::SourceLocation at, const clang::Token&, const clang::MacroDefinition&) override {
    count(at, 1);
  }
  void Elif(clang::SourceLocation at, clang::SourceRange, ConditionValueKind value,
            clang::SourceLocation) override {
    if (value != CVK_False) count(at, 1);  // in the midst of what is skipped
  }
  void Else(clang::SourceLocation at, clang::SourceLocation) override { count(at, 1); }

  void SourceRangeSkipped(clang::SourceRange range, clang::SourceLocation) override {
    const clang::SourceLocation begin = manager_.getExpansionLoc(range.getBegin());
    if (manager_.isInSystemHeader(begin)) return;
    count(begin, -1);
    const std::string& file = paths_.of(manager_.getFileID(begin));
    if (file.empty()) return;
    notes_.skipped.push_back({file, manager_.getFileOffset(begin), manager_.getFileOffset(range.getEnd()),
                              manager_.getSpellingLineNumber(begin), 1});
  }

  void EndOfMainFile() override {
    for (const auto& [where, times] : compiled_)
      if (times > 0) notes_.compiled.insert({paths_.of(where.first), where.second});
  }

 private:
  void count(clang::SourceLocation at, int times) {
    if (!manager_.isInSystemHeader(at))
      compiled_[{manager_.getFileID(at), manager_.getSpellingLineNumber(at)}] += times;
  }

  const clang::SourceManager& manager_;
  FilePaths paths_;
  PreprocessorNotes& notes_;
  std::map<std::pair<clang::FileID, unsigned>, int> compiled_;
};

/// Whether the macro makes a text of the parameter: #parameter
bool makes_text(const clang::MacroInfo& macro, const clang::IdentifierInfo* parameter) {
  bool after_hash = false;
  for (const clang::Token& token : macro.tokens()) {
    if (after_hash && token.getIdentifierInfo() == parameter) return true;
    after_hash = token.is(clang::tok::hash);
  }
  return false;
}

/// An argument reaches the compiler when one of its tokens does.
class MacroArguments : public clang::PPCallbacks {
 public:
  MacroArguments(const clang::SourceManager& manager, PreprocessorNotes& notes)
      : manager_(manager), paths_(manager), notes_(notes) {}

  void MacroExpands(const clang::Token&, const clang::MacroDefinition& definition, clang::SourceRange range,
                    const clang::MacroArgs* arguments) override {
    const clang::MacroInfo* macro = definition.getMacroInfo();
    if (!macro || !arguments || manager_.isInSystemHeader(manager_.getExpansionLoc(range.getBegin()))) return;
    for (unsigned i = 0; i < macro->getNumParams() && i < arguments->getNumMacroArguments(); ++i) {
      const std::optional<Range> written = range_of(arguments->getUnexpArgument(i));
      if (!written) continue;
      if (range.getBegin().isFileID()) written_.push_back(*written);
      if (makes_text(*macro, macro->params()[i])) notes_.texts.push_back(place(*written));
    }
  }

  /// A token that the compiler gets.
  void reached(const clang::Token& token) {
    if (token.isAnnotation() || !token.getLocation().isMacroID()) return;
    const auto [file, offset] = manager_.getDecomposedSpellingLoc(token.getLocation());
    if (!file.isInvalid()) reached_[file].insert(offset);
  }

  void EndOfMainFile() override {
    for (const Range& argument : written_) {
      const std::set<unsigned>& tokens = reached_[argument.file];
      const auto first = tokens.lower_bound(argument.begin);
      const bool is_kept = first != tokens.end() && *first < argument.end;
      Place where = place(argument);
      if (is_kept)
        notes_.kept.insert({std::move(where.file), where.begin});
      else
        notes_.dropped.push_back(std::move(where));
    }
  }

 private:
  /// Of a file.
  struct Range {
    clang::FileID file;
    unsigned begin = 0, end = 0;
  };

  /// Where an argument is written; none: nowhere, or not in one piece.
  std::optional<Range> range_of(const clang::Token* tokens) const {
    const unsigned length = clang::MacroArgs::getArgLength(tokens);
    if (length == 0) return {};
    const clang::Token& last = tokens[length - 1];
    const auto [file, begin] = manager_.getDecomposedSpellingLoc(tokens[0].getLocation());
    const auto [end_file, end] = manager_.getDecomposedSpellingLoc(last.getLocation());
    if (file != end_file || end < begin || !manager_.getFileEntryRefForID(file)) return {};
    return Range{file, begin, end + last.getLength()};
  }

  Place place(const Range& range) {
    Place place;
    place.file = paths_.of(range.file);
    place.begin = range.begin;
    place.end = range.end;
    place.line = manager_.getLineNumber(range.file, range.begin);
    place.column = manager_.getColumnNumber(range.file, range.begin);
    return place;
  }

  const clang::SourceManager& manager_;
  FilePaths paths_;
  PreprocessorNotes& notes_;
  std::vector<Range> written_;
  std::map<clang::FileID, std::set<unsigned>> reached_;
};

}  // namespace

void note_preprocessing(clang::Preprocessor& preprocessor, PreprocessorNotes& notes) {
  const clang::SourceManager& manager = preprocessor.getSourceManager();
  auto arguments = std::make_unique<MacroArguments>(manager, notes);
  preprocessor.setTokenWatcher(
      [noted = arguments.get()](const clang::Token& token) { noted->reached(token); });
  preprocessor.addPPCallbacks(std::move(arguments));
  preprocessor.addPPCallbacks(std::make_unique<Branches>(manager, notes));
}

}  // namespace tzc::rewriter
