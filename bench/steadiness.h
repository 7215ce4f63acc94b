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
  /// The least of late is above the most of early, by more than a hundredth: whatever grows steadily does so in the end,
  /// and what goes up and down does not.
  bool grew() const { return late.least > early.most + early.most / 100; }
};

/// Of looks at equal distances, in their order. With less than four the ranges are empty.
Trend trend_of(const std::vector<std::size_t>& looks);

}  // namespace bench
}  // namespace tzc
