// SPDX-License-Identifier: BSD-3-Clause
#include "pairing/alignment.h"

#include <algorithm>

namespace tzc::compare {
namespace {

using Digests = std::vector<std::uint64_t>;

constexpr std::ptrdiff_t most_differences = 2000;  // 32 MB of trace

/// The middle of two sequences whose equal ends have been cut off.
class Myers {
 public:
  Myers(const Digests& first, const Digests& second, std::size_t begin, std::size_t first_end,
        std::size_t second_end)
      : first_(first),
        second_(second),
        begin_(begin),
        n_(static_cast<std::ptrdiff_t>(first_end - begin)),
        m_(static_cast<std::ptrdiff_t>(second_end - begin)) {}

  std::vector<IndexPair> run() {
    const std::ptrdiff_t bound = std::min(n_ + m_, most_differences);
    std::vector<std::ptrdiff_t> furthest(2 * static_cast<std::size_t>(bound) + 3, 0);
    const std::ptrdiff_t centre = bound + 1;
    for (std::ptrdiff_t d = 0; d <= bound; ++d) {
      if (extend(furthest, centre, d)) return trace_back(d);
      trace_.emplace_back(furthest.begin() + (centre - d), furthest.begin() + (centre + d + 1));
    }
    return {};
  }

 private:
  /// Extends every path of d-1 differences by one; true when the end is reached.
  bool extend(std::vector<std::ptrdiff_t>& furthest, std::ptrdiff_t centre, std::ptrdiff_t d) const {
    for (std::ptrdiff_t k = -d; k <= d; k += 2) {
      std::ptrdiff_t& here = furthest[static_cast<std::size_t>(centre + k)];
      const std::ptrdiff_t from_below = furthest[static_cast<std::size_t>(centre + k + 1)];
      const std::ptrdiff_t from_left = furthest[static_cast<std::size_t>(centre + k - 1)];
      std::ptrdiff_t x = k == -d || (k != d && from_left < from_below) ? from_below : from_left + 1;
      while (x < n_ && x - k < m_ && equal(x, x - k)) ++x;
      here = x;
      if (x >= n_ && x - k >= m_) return true;
    }
    return false;
  }

  bool equal(std::ptrdiff_t x, std::ptrdiff_t y) const {
    return y >= 0 &&
           first_[begin_ + static_cast<std::size_t>(x)] == second_[begin_ + static_cast<std::size_t>(y)];
  }

  std::vector<IndexPair> trace_back(std::ptrdiff_t d) const {
    std::vector<IndexPair> pairs;
    std::ptrdiff_t x = n_, y = m_;
    for (; d > 0; --d) {
      const std::vector<std::ptrdiff_t>& before =
          trace_[static_cast<std::size_t>(d - 1)];  // diagonals -(d-1)..d-1
      const std::ptrdiff_t k = x - y;
      const auto at = [&](std::ptrdiff_t diagonal) {
        return diagonal < -(d - 1) || diagonal > d - 1 ? 0
                                                       : before[static_cast<std::size_t>(diagonal + d - 1)];
      };
      const bool down = k == -d || (k != d && at(k - 1) < at(k + 1));
      const std::ptrdiff_t from_x = down ? at(k + 1) : at(k - 1), from_y = from_x - (down ? k + 1 : k - 1);
      const std::ptrdiff_t snake_x = down ? from_x : from_x + 1;
      while (x > snake_x) add(pairs, --x, --y);
      x = from_x;
      y = from_y;
    }
    while (x > 0 && y > 0) add(pairs, --x, --y);
    std::reverse(pairs.begin(), pairs.end());
    return pairs;
  }

  void add(std::vector<IndexPair>& pairs, std::ptrdiff_t x, std::ptrdiff_t y) const {
    pairs.emplace_back(begin_ + static_cast<std::size_t>(x), begin_ + static_cast<std::size_t>(y));
  }

  const Digests& first_;
  const Digests& second_;
  const std::size_t begin_;
  const std::ptrdiff_t n_, m_;
  std::vector<std::vector<std::ptrdiff_t>> trace_;
};

}  // namespace

std::vector<IndexPair> align(const Digests& first, const Digests& second) {
  const std::size_t shorter = std::min(first.size(), second.size());
  std::size_t head = 0, tail = 0;
  while (head < shorter && first[head] == second[head]) ++head;
  while (tail < shorter - head && first[first.size() - 1 - tail] == second[second.size() - 1 - tail]) ++tail;
  std::vector<IndexPair> pairs;
  for (std::size_t i = 0; i < head; ++i) pairs.emplace_back(i, i);
  const std::vector<IndexPair> middle =
      Myers(first, second, head, first.size() - tail, second.size() - tail).run();
  pairs.insert(pairs.end(), middle.begin(), middle.end());
  for (std::size_t i = tail; i > 0; --i) pairs.emplace_back(first.size() - i, second.size() - i);
  return pairs;
}

std::size_t count_reordered(const std::vector<IndexPair>& pairs) {
  std::vector<std::size_t> ends;  // ends[n]: the smallest end of an ascending subsequence of n + 1
  for (const IndexPair& pair : pairs) {
    const auto place = std::lower_bound(ends.begin(), ends.end(), pair.second);
    if (place == ends.end()) {
      ends.push_back(pair.second);
    } else {
      *place = pair.second;
    }
  }
  return pairs.size() - ends.size();
}

}  // namespace tzc::compare
