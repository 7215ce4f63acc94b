// SPDX-License-Identifier: BSD-3-Clause
#include "edits/edited_lines.h"

#include <algorithm>

#include "edits/apply.h"
#include "edits/diff.h"

namespace tzc::rewriter {
namespace {

unsigned count_lines(const std::string& text, std::size_t begin, std::size_t end) {
  return static_cast<unsigned>(std::count(text.begin() + static_cast<long>(begin),
                                          text.begin() + static_cast<long>(std::min(end, text.size())),
                                          '\n'));
}

/// The old lines that each new line of a change stands for; line by line where their number stays.
void pair_change(unsigned before, unsigned removed, unsigned added, std::vector<LineRange>& ranges) {
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
    unsigned removed = 0, added = 0;
    for (; at < lines.size() && lines[at].change != LineChange::same; ++at)
      ++(lines[at].change == LineChange::removed ? removed : added);
    pair_change(before, removed, added, ranges);
    before += removed;
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
