// SPDX-License-Identifier: BSD-3-Clause
#include "format/line_width.h"

#include <clang/Format/Format.h>
#include <clang/Tooling/Core/Replacement.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "edits/diff.h"
#include "format/brackets.h"

namespace tzc::rewriter {
namespace {

constexpr std::size_t usual_width = 80;

std::size_t width_of(std::string_view line) {
  return line.find_last_not_of("\r\n") + 1;
}

std::size_t width_of_file(const std::string& content) {
  std::vector<std::size_t> widths;
  std::istringstream stream(content);
  for (std::string line; std::getline(stream, line);) widths.push_back(width_of(line));
  if (widths.empty()) return usual_width;
  std::sort(widths.begin(), widths.end());
  return std::max(usual_width, widths[widths.size() - 1 - widths.size() / 50]);
}

/// Whether the statement of the line below begins there.
bool ends_statement(std::string_view line) {
  line = without_comment(line);
  const std::size_t last = line.find_last_not_of(" \t\r\n");
  if (last == std::string_view::npos || line[line.find_first_not_of(" \t")] == '#') return true;
  return std::string_view(";{}:").find(line[last]) != std::string_view::npos;
}

/// A statement with lines that are too wide.
struct Wide {
  unsigned first;               ///< offset of its first word
  clang::tooling::Range lines;  ///< from the first one that is too wide to the last one that may move with it

  void reach(unsigned end) { lines = {lines.getOffset(), end - lines.getOffset()}; }
};

/// Tabs have no known width, and a directive cannot be broken.
bool can_be_broken(std::string_view line) {
  return line.find('\t') == std::string_view::npos && line[0] != '#';
}

/// Finds the statements of a file, line by line.
class WideStatements {
 public:
  explicit WideStatements(std::size_t width) : width_(width) {}

  void line(const DiffLine& line) {
    const unsigned end = offset_ + static_cast<unsigned>(line.text.size());
    if (begins_) begin(line.text);
    const bool is_wide =
        line.change == LineChange::added && width_of(line.text) > width_ && can_be_broken(line.text);
    if (is_wide && !is_found()) found_.push_back({first_, {offset_, 0}});
    if (is_found() && (is_wide || stands_behind_bracket(line.text))) found_.back().reach(end);
    read_brackets(line.text);
    begins_ = ends_statement(line.text);
    offset_ = end;
  }

  const std::vector<Wide>& found() const { return found_; }

 private:
  void begin(std::string_view line) {
    first_ = offset_ + static_cast<unsigned>(std::min(line.find_first_not_of(' '), line.size()));
    open_.clear();
  }

  /// The statement of this line is one.
  bool is_found() const { return !found_.empty() && found_.back().first == first_; }

  /// Right behind the innermost one that is open: the line moves when its bracket does.
  bool stands_behind_bracket(std::string_view line) const {
    return !open_.empty() && line.find_first_not_of(' ') == open_.back() + 1;
  }

  void read_brackets(std::string_view line) {
    const Brackets brackets = brackets_of(line);
    open_.resize(open_.size() - std::min(open_.size(), brackets.closed));
    open_.insert(open_.end(), brackets.open.begin(), brackets.open.end());
  }

  const std::size_t width_;
  std::vector<Wide> found_;
  unsigned offset_ = 0, first_ = 0;
  bool begins_ = true;
  std::vector<std::size_t> open_;  ///< columns of the statement's brackets
};

std::vector<Wide> wide_statements(const std::string& before, const std::string& after) {
  WideStatements statements(width_of_file(before));
  for (const DiffLine& line : diff_lines(before, after))
    if (line.change != LineChange::removed) statements.line(line);
  return statements.found();
}

/// What the lines that are indented least are indented by.
unsigned indent_width_of(const std::string& content) {
  std::size_t least = 8;
  std::istringstream stream(content);
  for (std::string line; std::getline(stream, line);)
    if (const std::size_t indent = line.find_first_not_of(' '); indent != std::string::npos && indent > 1)
      least = std::min(least, indent);
  return static_cast<unsigned>(least);
}

clang::format::FormatStyle style_for(const std::string& before) {
  clang::format::FormatStyle style = clang::format::getLLVMStyle();
  style.ColumnLimit = static_cast<unsigned>(width_of_file(before));
  style.IndentWidth = indent_width_of(before);
  style.MaxEmptyLinesToKeep = 1000;
  style.SortIncludes = clang::format::FormatStyle::SI_Never;
  style.ReflowComments = false;
  style.BreakStringLiterals = false;
  return style;
}

/// Whether a replacement breaks or joins lines of a statement, behind its first word.
bool is_break(const clang::tooling::Replacement& replacement, const std::string& text, const Wide& wide) {
  const unsigned at = replacement.getOffset(), end = at + replacement.getLength();
  const bool breaks = replacement.getReplacementText().contains('\n') ||
                      text.substr(at, replacement.getLength()).find('\n') != std::string::npos;
  return breaks && at > wide.first && end < wide.lines.getOffset() + wide.lines.getLength();
}

/// By how much the statement's first word, which stays where it is, stands right of where clang-format wants it.
int shift_of(const clang::tooling::Replacements& replacements, const std::string& text, const Wide& wide) {
  for (const auto& replacement : replacements) {
    const std::size_t newline = replacement.getReplacementText().rfind('\n');
    if (replacement.getOffset() + replacement.getLength() != wide.first || newline == llvm::StringRef::npos)
      continue;
    const std::size_t line = wide.first == 0 ? std::string::npos : text.rfind('\n', wide.first - 1);
    const std::size_t column = wide.first - (line == std::string::npos ? 0 : line + 1);
    return static_cast<int>(column) - static_cast<int>(replacement.getReplacementText().size() - newline - 1);
  }
  return 0;
}

/// A replacement with the indentation behind its line break moved.
clang::tooling::Replacement moved(const clang::tooling::Replacement& replacement, int shift) {
  std::string text = replacement.getReplacementText().str();
  const std::size_t newline = text.rfind('\n');
  if (newline != std::string::npos) {
    const int indent = static_cast<int>(text.size() - newline - 1) + shift;
    text = text.substr(0, newline + 1) + std::string(static_cast<std::size_t>(std::max(indent, 0)), ' ');
  }
  return {replacement.getFilePath(), replacement.getOffset(), replacement.getLength(), text};
}

}  // namespace

std::string wrapped(const std::string& path, const std::string& before, const std::string& after) {
  const std::vector<Wide> statements = wide_statements(before, after);
  if (statements.empty()) return after;
  std::vector<clang::tooling::Range> ranges;
  for (const Wide& wide : statements) ranges.push_back(wide.lines);
  const clang::tooling::Replacements all = clang::format::reformat(style_for(before), after, ranges, path);
  clang::tooling::Replacements breaks;
  for (const Wide& wide : statements)
    for (const auto& replacement : all)
      if (is_break(replacement, after, wide))
        if (llvm::Error failed = breaks.add(moved(replacement, shift_of(all, after, wide))))
          return llvm::consumeError(std::move(failed)), after;
  llvm::Expected<std::string> text = clang::tooling::applyAllReplacements(after, breaks);
  return text ? *text : (llvm::consumeError(text.takeError()), after);
}

}  // namespace tzc::rewriter
