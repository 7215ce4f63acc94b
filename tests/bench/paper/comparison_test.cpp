// SPDX-License-Identifier: BSD-3-Clause
#include "paper/comparison.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_up.h"

namespace {

using namespace tzc::bench;
using testing::ElementsAre;
using tzc::test::made_up;

constexpr std::size_t small = 4 << 10, large = 4 << 20;

/// One message to each subscriber; 0 is one that was lost.
Summary summary_of(const char* contender, std::size_t size, const std::vector<std::uint64_t>& latencies_ns) {
  std::vector<std::vector<std::uint64_t>> by_subscriber;
  for (const std::uint64_t ns : latencies_ns) by_subscriber.push_back({ns});
  return summarize({{contender, size, latencies_ns.size()}, {{0, made_up(by_subscriber)}}}, 10);
}

TEST(Overview, has_the_worst_of_each_contender) {
  const auto rows = overview_table({summary_of("a", small, {1000}), summary_of("b", small, {5000}),
                                    summary_of("a", large, {3000}), summary_of("a", small, {2000, 2000}),
                                    summary_of("a", large, {2200, 0})})
                        .rows;
  EXPECT_THAT(rows, ElementsAre(ElementsAre("a", "4", "4", "0.000000", "3.0", "3.0", "3.00"),
                                ElementsAre("b", "1", "1", "1.000000", "5.0", "5.0", "")));
}

TEST(Overview, counts_cells_that_held_the_rate) {
  Summary slow = summary_of("a", small, {1000});
  slow.holds_rate = false;
  EXPECT_EQ(overview_table({slow, summary_of("a", large, {1000})}).rows.front()[2], "1");
}

TEST(Ranking, has_the_fastest_first_whoever_that_is) {
  const auto rows =
      ranking_table({summary_of("tzc", large, {3000}), summary_of("other", large, {2000}),
                     summary_of("tzc", small, {1000, 1000}), summary_of("lossy", small, {500, 0})})
          .rows;
  EXPECT_THAT(rows, ElementsAre(ElementsAre("4096", "2", "lossy 0.5*, tzc 1.0"),
                                ElementsAre("4194304", "1", "other 2.0, tzc 3.0")));
}

TEST(Ranking, leaves_out_where_nothing_arrived) {
  EXPECT_TRUE(ranking_table({summary_of("a", small, {0})}).rows.empty());
}

}  // namespace
