// SPDX-License-Identifier: BSD-3-Clause
#include "edits/edited_lines.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "edits/apply.h"
#include "edits/diff.h"

namespace tzc::rewriter {
namespace {

unsigned count_lines(const std::string& text, std::size_t begin, std::size_t end) {
  return static_cast<unsigned>(std::count(text.begin() + static_cast<long>(begin),
                                          text.begin() + static_cast<long>(std::min(end, text.size())),
                                          '\n'));
}

/// Lines that a comparison has on one of its sides, one after the other.
struct Lines {
  std::vector<std::string_view> texts;

  /// For each character that is no space, its line, from 1.
  std::vector<unsigned> of_characters() const;
  std::string characters() const;
};

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

std::vector<unsigned> Lines::of_characters() const {
  std::vector<unsigned> lines;
  for (std::size_t i = 0; i < texts.size(); ++i)
    lines.insert(lines.end(),
                 static_cast<std::size_t>(
                     std::count_if(texts[i].begin(), texts[i].end(), [](char c) { return !is_space(c); })),
                 static_cast<unsigned>(i) + 1);
  return lines;
}

std::string Lines::characters() const {
  std::string all;
  for (const std::string_view text : texts)
    std::remove_copy_if(text.begin(), text.end(), std::back_inserter(all), is_space);
  return all;
}

/// Formatting that only breaks and joins lines says exactly which old lines a new one stands for.
bool pair_characters(unsigned before, const Lines& removed, const Lines& added,
                     std::vector<LineRange>& ranges) {
  if (removed.characters() != added.characters()) return false;
  const std::vector<unsigned> of_old = removed.of_characters(), of_new = added.of_characters();
  for (unsigned line = 1; line <= added.texts.size(); ++line) {
    const auto [first, last] = std::equal_range(of_new.begin(), of_new.end(), line);
    const auto old_line = [&](std::ptrdiff_t at) { return before + of_old[static_cast<std::size_t>(at)]; };
    if (first != last)
      ranges.push_back({old_line(first - of_new.begin()), old_line(last - of_new.begin() - 1)});
    else
      ranges.push_back(ranges.empty() ? LineRange{before + 1, before + 1} : ranges.back());
  }
  return true;
}

/// The old lines that each new line of a change stands for; line by line where their number stays.
void pair_change(unsigned before, const Lines& old_lines, const Lines& new_lines,
                 std::vector<LineRange>& ranges) {
  const auto removed = static_cast<unsigned>(old_lines.texts.size());
  const auto added = static_cast<unsigned>(new_lines.texts.size());
  if (removed > 0 && pair_characters(before, old_lines, new_lines, ranges)) return;
  for (unsigned i = 1; i <= added; ++i) {
    if (removed == added)
      ranges.push_back({before + i, before + i});
    else if (removed > 0)
      ranges.push_back({before + 1, before + removed});
    else
      ranges.push_back({std::max(before, 1U), before + 1});
  }
}

std::vector<LineRange> compare(const std::string& old_text, const std::string& new_text) {
  const std::vector<DiffLine> lines = diff_lines(old_text, new_text);
  std::vector<LineRange> ranges;
  unsigned before = 0;
  for (std::size_t at = 0; at < lines.size();) {
    Lines removed, added;
    for (; at < lines.size() && lines[at].change != LineChange::same; ++at)
      (lines[at].change == LineChange::removed ? removed : added).texts.push_back(lines[at].text);
    pair_change(before, removed, added, ranges);
    before += static_cast<unsigned>(removed.texts.size());
    for (; at < lines.size() && lines[at].change == LineChange::same; ++at) {
      ++before;
      ranges.push_back({before, before});
    }
  }
  return ranges;
}

}  // namespace

EditedLines::EditedLines(const std::string& original, const Edits& edits, const std::string& written) {
  learn_edits(original, edits);
  const Expected<std::string> edited = apply_edits(original, edits);
  if (edited && *edited != written) unformatted_ = compare(*edited, written);
}

void EditedLines::learn_edits(const std::string& original, const Edits& edits) {
  for (const Edit& edit : in_order(edits))
    edits_.push_back({1 + count_lines(original, 0, edit.offset),
                      static_cast<int>(count_lines(edit.text, 0, edit.text.size())) -
                          static_cast<int>(count_lines(original, edit.offset, edit.offset + edit.length))});
}

unsigned EditedLines::before_edits(unsigned line) const {
  int shift = 0;
  const int wanted = static_cast<int>(line);
  for (const EditedPlace& edit : edits_) {
    const int start = static_cast<int>(edit.line) + shift;
    if (start >= wanted) break;
    if (start + edit.grown >= wanted) return edit.line;
    shift += edit.grown;
  }
  return static_cast<unsigned>(std::max(1, wanted - shift));
}

LineRange EditedLines::original(unsigned written_line) const {
  if (unformatted_.empty() || written_line == 0) {
    const unsigned line = before_edits(written_line);
    return {line, line};
  }
  const LineRange range = unformatted_[std::min<std::size_t>(written_line, unformatted_.size()) - 1];
  return {before_edits(range.first), before_edits(range.last)};
}

}  // namespace tzc::rewriter
