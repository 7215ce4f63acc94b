// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace tzc {
namespace bench {

/// The value below which the share `at` (0 to 1) of the values lies: linear between the two nearest ones (R's
/// type 7, NumPy's default). `sorted` must not be empty.
double quantile(const std::vector<double>& sorted, double at);

struct Spread {
  std::size_t count;
  double least, p1, q1, median, q3, p99, most, mean;
};

/// Nothing for no values.
std::optional<Spread> spread_of(std::vector<double> values);

}  // namespace bench
}  // namespace tzc
