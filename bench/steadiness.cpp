// SPDX-License-Identifier: BSD-3-Clause
#include "steadiness.h"

#include <algorithm>

namespace tzc {
namespace bench {
namespace {

Range range_of(std::vector<std::size_t>::const_iterator begin, std::vector<std::size_t>::const_iterator end) {
  if (begin == end) return {};
  const auto [least, most] = std::minmax_element(begin, end);
  return {*least, *most};
}

}  // namespace

Trend trend_of(const std::vector<std::size_t>& looks) {
  const auto quarter = static_cast<std::ptrdiff_t>(looks.size() / 4);
  return {range_of(looks.begin() + quarter, looks.begin() + 2 * quarter),
          range_of(looks.end() - quarter, looks.end())};
}

}  // namespace bench
}  // namespace tzc
