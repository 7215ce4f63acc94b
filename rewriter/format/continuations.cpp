// SPDX-License-Identifier: BSD-3-Clause
#include "format/continuations.h"

#include <algorithm>
#include <vector>

#include "edits/diff.h"
#include "format/brackets.h"

namespace tzc::rewriter {
namespace {

/// A line before and after the edits.
struct Pair {
  std::string before;
  std::string* after;
};

/// A line of the result.
struct Line {
  LineChange change;
  std::string text;
};

/// Pairs the changed lines of a run by the order of those that leave brackets open.
void pair_changed(std::vector<Pair>& pairs, std::vector<std::string*>& removed,
                  std::vector<std::string*>& added) {
  const auto is_closed = [](const std::string* line) { return brackets_of(*line).open.empty(); };
  const bool as_they_come = removed.size() == added.size();
  if (!as_they_come) {
    removed.erase(std::remove_if(removed.begin(), removed.end(), is_closed), removed.end());
    added.erase(std::remove_if(added.begin(), added.end(), is_closed), added.end());
  }
  for (std::size_t i = 0; removed.size() == added.size() && i < removed.size(); ++i)
    pairs.push_back({*removed[i], added[i]});
  removed.clear();
  added.clear();
}

std::vector<Pair> pairs_of(std::vector<Line>& lines) {
  std::vector<Pair> pairs;
  std::vector<std::string*> removed, added;
  for (Line& line : lines) {
    if (line.change == LineChange::removed) removed.push_back(&line.text);
    if (line.change == LineChange::added) added.push_back(&line.text);
    if (line.change == LineChange::removed || line.change == LineChange::added) continue;
    pair_changed(pairs, removed, added);
    pairs.push_back({line.text, &line.text});
  }
  pair_changed(pairs, removed, added);
  return pairs;
}

/// The columns of an open bracket before and after.
struct OpenBracket {
  std::size_t before, after;
};

class Realigner {
 public:
  void line(const Pair& pair) {
    if (!open_.empty()) align(pair.before, *pair.after);
    const Brackets old_ones = brackets_of(pair.before), new_ones = brackets_of(*pair.after);
    const bool fits = old_ones.open.size() == new_ones.open.size() && old_ones.closed == new_ones.closed;
    for (std::size_t i = 0; fits && i < old_ones.closed && !open_.empty(); ++i) open_.pop_back();
    if (!fits) open_.clear();
    for (std::size_t i = 0; fits && i < old_ones.open.size(); ++i)
      open_.push_back({old_ones.open[i], new_ones.open[i]});
  }

 private:
  /// Only spaces can stand behind a bracket.
  void align(const std::string& before, std::string& after) const {
    const OpenBracket& bracket = open_.back();
    const std::size_t indent = before.find_first_not_of(' ');
    if (bracket.before == bracket.after || indent != bracket.before + 1) return;
    if (after.find_first_not_of(' ') != indent) return;
    after = std::string(bracket.after + 1, ' ') + after.substr(indent);
  }

  std::vector<OpenBracket> open_;
};

}  // namespace

std::string realigned(const std::string& before, const std::string& after) {
  std::vector<Line> lines;
  for (const DiffLine& line : diff_lines(before, after))
    lines.push_back({line.change, std::string(line.text)});
  Realigner realigner;
  for (const Pair& pair : pairs_of(lines)) realigner.line(pair);
  std::string text;
  for (const Line& line : lines)
    if (line.change != LineChange::removed) text += line.text;
  return text;
}

}  // namespace tzc::rewriter
