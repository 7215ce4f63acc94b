// SPDX-License-Identifier: BSD-3-Clause
#include "paper/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tzc {
namespace bench {

double quantile(const std::vector<double>& sorted, double at) {
  const double place = at * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - std::floor(place)) * (sorted[above] - sorted[below]);
}

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  return Spread{values.size(),          values.front(),        quantile(values, 0.01),
                quantile(values, 0.25), quantile(values, 0.5), quantile(values, 0.75),
                quantile(values, 0.99), values.back(),         mean};
}

}  // namespace bench
}  // namespace tzc
