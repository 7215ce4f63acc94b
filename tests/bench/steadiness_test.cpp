// SPDX-License-Identifier: BSD-3-Clause
#include "steadiness.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

namespace {

using namespace tzc::bench;

std::vector<std::size_t> looks(std::size_t count, const std::function<double(double)>& value) {
  std::vector<std::size_t> all;
  for (std::size_t i = 0; i < count; ++i)
    all.push_back(static_cast<std::size_t>(value(static_cast<double>(i))));
  return all;
}

TEST(Trend, early_is_the_second_quarter_and_late_the_last) {
  const Trend trend = trend_of({90, 91, 5, 3, 80, 81, 7, 9});
  EXPECT_EQ(trend.early.least, 3u);
  EXPECT_EQ(trend.early.most, 5u);
  EXPECT_EQ(trend.late.least, 7u);
  EXPECT_EQ(trend.late.most, 9u);
}

TEST(Trend, one_descriptor_more_grew) {
  EXPECT_TRUE(trend_of({40, 40, 40, 40, 40, 41, 41, 41}).grew());
}

TEST(Trend, a_hundredth_of_the_memory_is_no_growth) {
  EXPECT_FALSE(trend_of({10000, 10000, 10000, 10000, 10050, 10099, 10100, 10100}).grew());
  EXPECT_TRUE(trend_of({10000, 10000, 10000, 10000, 10050, 10099, 10101, 10101}).grew());
}

TEST(Trend, what_a_control_grew_by_as_well_is_not_counted) {
  const Trend trend = trend_of({10000, 10000, 10000, 10000, 10050, 10150, 10150, 10160});
  EXPECT_EQ(trend.growth(), 150u);
  EXPECT_TRUE(trend.grew(49));
  EXPECT_FALSE(trend.grew(50));
}

TEST(Trend, a_leak_under_noise_grew) {
  std::mt19937 random{1};
  const auto noise = [&random] { return static_cast<double>(random() % 200); };
  EXPECT_TRUE(trend_of(looks(120, [&](double i) { return 4000 + 10 * i + noise(); })).grew());
}

TEST(Trend, what_goes_up_and_down_did_not_grow) {
  std::mt19937 random{1};
  EXPECT_FALSE(
      trend_of(looks(120, [&](double) { return 4000 + static_cast<double>(random() % 2000); })).grew());
}

TEST(Trend, what_grows_only_while_it_warms_up_did_not_grow) {
  EXPECT_FALSE(trend_of(looks(120, [](double i) { return i < 30 ? 1000 + 100 * i : 4000; })).grew());
}

TEST(Trend, too_few_looks_say_nothing) {
  EXPECT_FALSE(trend_of({}).grew());
  EXPECT_FALSE(trend_of({1, 2, 3}).grew());
}

}  // namespace
