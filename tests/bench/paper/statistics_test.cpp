// SPDX-License-Identifier: BSD-3-Clause
#include "paper/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace {

using tzc::bench::quantile;
using tzc::bench::spread_of;

// numpy.percentile([15, 20, 35, 40, 50], ...) of NumPy's documentation and R's quantile(type = 7) give these.
TEST(Quantile, is_linear_between_the_nearest_values) {
  const std::vector<double> values{15, 20, 35, 40, 50};
  EXPECT_DOUBLE_EQ(quantile(values, 0), 15);
  EXPECT_DOUBLE_EQ(quantile(values, 0.25), 20);
  EXPECT_DOUBLE_EQ(quantile(values, 0.4), 29);
  EXPECT_DOUBLE_EQ(quantile(values, 0.5), 35);
  EXPECT_DOUBLE_EQ(quantile(values, 0.99), 49.6);
  EXPECT_DOUBLE_EQ(quantile(values, 1), 50);
}

TEST(Quantile, of_one_value_is_that_value) {
  for (const double at : {0.0, 0.01, 0.5, 1.0}) EXPECT_DOUBLE_EQ(quantile({7}, at), 7);
}

// Of 4 n + 1 distinct values exactly n lie below the first quartile, 2 n below the median, 3 n below the third.
TEST(Quantile, splits_the_values_in_quarters) {
  std::mt19937 random(1);
  for (const std::size_t n : {1, 2, 25, 250}) {
    std::vector<double> values(4 * n + 1);
    std::iota(values.begin(), values.end(), 1000.0);
    std::shuffle(values.begin(), values.end(), random);
    const auto spread = spread_of(values);
    const auto below = [&](double limit) {
      return static_cast<std::size_t>(
          std::count_if(values.begin(), values.end(), [&](double value) { return value < limit; }));
    };
    EXPECT_EQ(below(spread->q1), n);
    EXPECT_EQ(below(spread->median), 2 * n);
    EXPECT_EQ(below(spread->q3), 3 * n);
  }
}

TEST(Spread, of_no_values_is_nothing) {
  EXPECT_FALSE(spread_of({}).has_value());
}

TEST(Spread, does_not_depend_on_the_order) {
  const auto spread = spread_of({9, 1, 5});
  EXPECT_EQ(spread->count, 3u);
  EXPECT_DOUBLE_EQ(spread->least, 1);
  EXPECT_DOUBLE_EQ(spread->median, 5);
  EXPECT_DOUBLE_EQ(spread->most, 9);
  EXPECT_DOUBLE_EQ(spread->mean, 5);
}

}  // namespace
