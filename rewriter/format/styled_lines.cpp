// SPDX-License-Identifier: BSD-3-Clause
#include "format/styled_lines.h"

#include <algorithm>
#include <set>
#include <vector>

#include "edits/diff.h"
#include "format/brackets.h"

namespace tzc::rewriter {
namespace {

constexpr const char* blanks = " \t\r\n\v\f";

std::size_t words_in(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return std::string_view(blanks).find(c) == std::string_view::npos;
  }));
}

std::string without_blanks(std::string text) {
  text.erase(
      std::remove_if(text.begin(), text.end(),
                     [](char c) { return std::string_view(blanks).find(c) != std::string_view::npos; }),
      text.end());
  return text;
}

std::string_view indentation_of(std::string_view line) {
  return line.substr(0, std::min(line.find_first_not_of(" \t"), line.size()));
}

std::size_t behind(char c, std::size_t column, unsigned tab_width) {
  if (c == '\t') return column + tab_width - column % tab_width;
  const bool continues_character = (static_cast<unsigned char>(c) & 0xC0) == 0x80;  // in UTF-8
  return continues_character ? column : column + 1;
}

/// The column behind this begin of a line.
std::size_t width_of(std::string_view text, unsigned tab_width) {
  std::size_t column = 0;
  for (const char c : text) column = behind(c, column, tab_width);
  return column;
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    lines.push_back(text.substr(0, std::min(text.find('\n'), text.size() - 1) + 1));
    text.remove_prefix(lines.back().size());
  }
  return lines;
}

/// Follows a text line by line: which brackets of the statement are open, and whether the next line continues it. In doubt it
/// begins one (behind `)`, a comment, a macro): it keeps its indentation then.
template <class Bracket>
class Statement {
 public:
  bool is_continued() const { return !open_.empty() || ends_with_operator_; }
  const std::vector<Bracket>& open() const { return open_; }

  template <class MakeBracket>
  void line(std::string_view line, MakeBracket make) {
    const Brackets brackets = brackets_of(line);
    open_.resize(open_.size() - std::min(open_.size(), brackets.closed));
    for (const std::size_t column : brackets.open) open_.push_back(make(column));
    const std::string_view code = without_comment(line);
    const std::size_t last = code.find_last_not_of(blanks);
    const char end = last == std::string_view::npos ? ';' : code[last];
    const bool is_directive = last != std::string_view::npos && code[code.find_first_not_of(blanks)] == '#';
    ends_with_operator_ = !is_directive && std::string_view("=,+-|&?<").find(end) != std::string_view::npos;
    if (is_directive || std::string_view(";{}").find(end) != std::string_view::npos) open_.clear();
  }

 private:
  std::vector<Bracket> open_;
  bool ends_with_operator_ = false;
};

/// Says which replacements may be made.
class ChangedLines {
 public:
  ChangedLines(const std::string& before, const std::string& after) : text_(after) {
    Statement<std::size_t> statement;
    std::size_t begin = 0;
    for (const DiffLine& line : diff_lines(before, after)) {
      if (line.change == LineChange::removed) continue;
      lines_.push_back({begin, line.change == LineChange::added, statement.is_continued()});
      statement.line(line.text, [](std::size_t column) { return column; });
      begin += line.text.size();
    }
  }

  bool allow(const clang::tooling::Replacement& replacement) const {
    const std::size_t begin = replacement.getOffset(), end = begin + replacement.getLength();
    const std::string_view now = std::string_view(text_).substr(begin, end - begin);
    const std::string_view then{replacement.getReplacementText().data(),
                                replacement.getReplacementText().size()};
    if (lines_.empty() || end >= text_.size() || words_in(now) + words_in(then) != 0) return false;
    const Line &first = line_at(begin), &last = line_at(end);
    if (!last.is_changed || (begin == first.begin && begin != end)) return false;
    if (&first == &last) return true;
    if (!last.continues) return false;
    const auto breaks = std::count(now.begin(), now.end(), '\n');
    const std::size_t line_break = then.find('\n');
    if (line_break == std::string_view::npos) return first.is_changed && breaks == 1;  // no empty line goes
    return breaks == std::count(then.begin(), then.end(), '\n') &&
           now.substr(0, now.find('\n')) == then.substr(0, line_break);
  }

 private:
  struct Line {
    std::size_t begin;
    bool is_changed;
    bool continues;  ///< the statement of the line above
  };

  const Line& line_at(std::size_t offset) const {
    return *(std::upper_bound(lines_.begin(), lines_.end(), offset,
                              [](std::size_t at, const Line& line) { return at < line.begin; }) -
             1);
  }

  const std::string& text_;
  std::vector<Line> lines_;
};

/// Where clang-format has each character that is no blank.
struct Layout {
  struct Place {
    std::size_t column, indentation;
  };
  std::vector<Place> words;

  Layout(const std::string& text, unsigned tab_width) {
    for (const std::string_view line : lines_of(text)) {
      const std::size_t indentation = width_of(indentation_of(line), tab_width);
      std::size_t column = 0;
      for (const char& c : line) {
        if (words_in({&c, 1}) != 0) words.push_back({column, indentation});
        column = behind(c, column, tab_width);
      }
    }
  }
};

/// Moves lines to where the layout has them, as seen from their bracket or, without one, from the begin of their statement.
class Indenter {
 public:
  Indenter(const Layout& layout, const std::set<std::size_t>& moving, unsigned tab_width)
      : layout_(layout), moving_(moving), tab_width_(tab_width) {}

  void line(std::string line) {
    const std::string indentation(indentation_of(line));
    if (words_in(line) != 0 && moving_.count(word_) != 0)
      line.replace(0, indentation.size(), moved(indentation));
    else if (words_in(line) != 0 && statement_.open().empty())
      start_ = {word_, 0, indentation};
    statement_.line(line, [&](std::size_t at) {
      return Reference{word_ + words_in(line.substr(0, at)),
                       width_of(std::string_view(line).substr(0, at), tab_width_),
                       std::string(indentation_of(line))};
    });
    word_ += words_in(line);
    text_ += line;
  }

  const std::string& text() const { return text_; }

 private:
  /// What a line is placed by: a bracket, or the begin of the statement.
  struct Reference {
    std::size_t word, column;
    std::string indentation;
  };

  std::string moved(const std::string& indentation) const {
    const bool has_bracket = !statement_.open().empty();
    const Reference& reference = has_bracket ? statement_.open().back() : start_;
    const Layout::Place wanted = layout_.words[word_], there = layout_.words[reference.word];
    const std::size_t own = width_of(reference.indentation, tab_width_);
    std::size_t column = std::max(own + wanted.column, there.indentation) - there.indentation;
    if (has_bracket && wanted.column == there.column + 1) column = reference.column + 1;
    if (column == width_of(indentation, tab_width_)) return indentation;
    return column < own ? std::string(column, ' ') : reference.indentation + std::string(column - own, ' ');
  }

  const Layout& layout_;
  const std::set<std::size_t>& moving_;
  const unsigned tab_width_;
  Statement<Reference> statement_;
  Reference start_{0, 0, ""};
  std::size_t word_ = 0;  ///< the index of the next character that is no blank
  std::string text_;
};

}  // namespace

std::string with_changed_lines_styled(const std::string& before, const std::string& after,
                                      const clang::tooling::Replacements& replacements, unsigned tab_width) {
  llvm::Expected<std::string> whole = clang::tooling::applyAllReplacements(after, replacements);
  if (!whole) return llvm::consumeError(whole.takeError()), "";
  if (without_blanks(*whole) != without_blanks(after)) return "";
  const ChangedLines changed(before, after);
  clang::tooling::Replacements allowed;
  std::set<std::size_t> moving;
  for (const auto& replacement : replacements) {
    if (!changed.allow(replacement)) continue;
    if (llvm::Error failed = allowed.add(replacement)) return llvm::consumeError(std::move(failed)), "";
    if (replacement.getReplacementText().contains('\n'))
      moving.insert(words_in(std::string_view(after).substr(0, replacement.getOffset())));
  }
  llvm::Expected<std::string> text = clang::tooling::applyAllReplacements(after, allowed);
  if (!text) return llvm::consumeError(text.takeError()), "";
  const Layout layout(*whole, std::max(tab_width, 1u));
  Indenter indenter(layout, moving, std::max(tab_width, 1u));
  for (const std::string_view line : lines_of(*text)) indenter.line(std::string(line));
  return indenter.text();
}

}  // namespace tzc::rewriter
