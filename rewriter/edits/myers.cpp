// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string_view>
#include <vector>

#include "edits/diff.h"

namespace tzc::rewriter {
namespace {

using Lines = std::vector<std::string_view>;

Lines split(std::string_view text) {
  Lines lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.push_back(text.substr(0, end));
    text.remove_prefix(end);
  }
  return lines;
}

/// Myers' greedy walk over the edit graph: x counts lines of `before`, y lines of `after`, k = x - y.
class Walk {
 public:
  Walk(const Lines& before, const Lines& after) : before_(before), after_(after) {}

  std::vector<DiffLine> run() {
    const int most = size(before_) + size(after_);
    furthest_.assign(2 * most + 3, 0);
    middle_ = most + 1;
    for (int d = 0; d <= most; ++d) {
      trace_.push_back(furthest_);
      if (round(d)) break;
    }
    return backtrack();
  }

 private:
  static int size(const Lines& lines) { return static_cast<int>(lines.size()); }

  bool comes_from_above(const std::vector<int>& furthest, int k, int d) const {
    return k == -d || (k != d && furthest[middle_ + k - 1] < furthest[middle_ + k + 1]);
  }

  /// All paths with `d` changes; true when one of them reaches the end.
  bool round(int d) {
    for (int k = -d; k <= d; k += 2) {
      int x = comes_from_above(furthest_, k, d) ? furthest_[middle_ + k + 1] : furthest_[middle_ + k - 1] + 1;
      while (x < size(before_) && x - k < size(after_) && before_[x] == after_[x - k]) ++x;
      furthest_[middle_ + k] = x;
      if (x >= size(before_) && x - k >= size(after_)) return true;
    }
    return false;
  }

  std::vector<DiffLine> backtrack() {
    int x = size(before_), y = size(after_);
    for (int d = static_cast<int>(trace_.size()) - 1; d > 0; --d) {
      const bool above = comes_from_above(trace_[d], x - y, d);
      const int k = x - y + (above ? 1 : -1);
      const int from_x = trace_[d][middle_ + k], from_y = from_x - k;
      while (x > from_x && y > from_y) same(x--, y--);
      if (above)
        script_.push_back({LineChange::added, after_[y - 1], 0, static_cast<unsigned>(y)}), --y;
      else
        script_.push_back({LineChange::removed, before_[x - 1], static_cast<unsigned>(x), 0}), --x;
    }
    while (x > 0) same(x--, y--);
    std::reverse(script_.begin(), script_.end());
    return std::move(script_);
  }

  void same(int x, int y) {
    script_.push_back({LineChange::same, before_[x - 1], static_cast<unsigned>(x), static_cast<unsigned>(y)});
  }

  const Lines& before_;
  const Lines& after_;
  std::vector<int> furthest_;
  std::vector<std::vector<int>> trace_;
  int middle_ = 0;
  std::vector<DiffLine> script_;
};

/// Removed lines before added ones within one run of changes, as every diff shows them.
void group_changes(std::vector<DiffLine>& lines) {
  auto changed = [](const DiffLine& line) { return line.change != LineChange::same; };
  for (auto at = lines.begin(); at != lines.end();) {
    const auto first = std::find_if(at, lines.end(), changed);
    const auto last = std::find_if_not(first, lines.end(), changed);
    std::stable_partition(first, last, [](const DiffLine& l) { return l.change == LineChange::removed; });
    at = last;
  }
}

}  // namespace

std::vector<DiffLine> diff_lines(std::string_view before, std::string_view after) {
  const Lines old_lines = split(before), new_lines = split(after);
  std::vector<DiffLine> lines = Walk(old_lines, new_lines).run();
  group_changes(lines);
  return lines;
}

}  // namespace tzc::rewriter
