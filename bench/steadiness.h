// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace tzc {
namespace bench {

struct Range {
  std::size_t least = 0;
  std::size_t most = 0;
};

/// What a quantity of a process came to over time. Early: the second quarter of the looks, when the process is warm; late: the last.
struct Trend {
  Range early;
  Range late;
  /// The least of late above the most of early: whatever grows steadily does so in the end, and what goes up and down does not.
  std::size_t growth() const { return late.least > early.most ? late.least - early.most : 0; }
  /// By more than a hundredth, and what a control beside it grew by.
  bool grew(std::size_t of_the_control = 0) const { return growth() > early.most / 100 + of_the_control; }
};

/// Of looks at equal distances, in their order. With less than four the ranges are empty.
Trend trend_of(const std::vector<std::size_t>& looks);

}  // namespace bench
}  // namespace tzc
