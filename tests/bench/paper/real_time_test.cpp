// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "made_up.h"
#include "paper/real_time_results.h"

namespace tzc::bench {
namespace {

using test::made_up;
using testing::ElementsAre;
using testing::HasSubstr;

const Cell in_loop{"tzc", 4096, 1, in_real_time};

/// Published at these times; each message took its latency.
Measurement published(std::vector<std::int64_t> at_ns, std::vector<std::uint64_t> latency_ns) {
  Measurement round = made_up({std::move(latency_ns)});
  round.published_ns = std::move(at_ns);
  return round;
}

RealTimeFigures figures_of(Measurement round) {
  const auto figures = real_time_figures({{in_loop, {{0, std::move(round)}}}}, 1000);
  return figures.at(0);
}

TEST(RealTimeResults, the_error_of_a_period_is_that_of_the_times_of_delivery) {
  // Deliveries at 0.010, 1.030, 2.015 ms: periods of 1.020 and 0.985 ms.
  const RealTimeFigures figures = figures_of(published({0, 1'000'000, 2'000'000}, {10'000, 30'000, 15'000}));
  EXPECT_THAT(figures.period_errors_us, ElementsAre(testing::DoubleEq(15), testing::DoubleEq(20)));
  EXPECT_THAT(figures.latencies_us, ElementsAre(10, 15, 30));
}

TEST(RealTimeResults, a_message_that_did_not_arrive_ends_two_periods_and_makes_none) {
  const RealTimeFigures figures = figures_of(published({0, 0, 2'000'000, 3'000'000}, {1000, 0, 1000, 1000}));
  EXPECT_THAT(figures.period_errors_us, ElementsAre(0));
  EXPECT_THAT(figures.delivered, ElementsAre(3));
  EXPECT_EQ(figures.sent, 4U);
}

TEST(RealTimeResults, what_was_sent_stands_beside_the_share_of_the_subscriber_that_got_fewest) {
  Measurement round = made_up({{1000, 1000, 1000, 1000}, {1000, 0, 1000, 1000}});
  round.published_ns = {0, 1'000'000, 2'000'000, 3'000'000};
  const CellResult result{{"tzc", 4096, 2, in_real_time}, {{0, round}, {1, round}}};
  const Table table = real_time_table(real_time_figures({result}, 1000));
  ASSERT_EQ(table.rows.size(), 1U);
  EXPECT_EQ(table.columns[4], "sent");
  EXPECT_EQ(table.rows[0][4], "8");
  EXPECT_EQ(table.columns[5], "least_delivered_share");
  EXPECT_EQ(table.rows[0][5], "0.750000");
}

TEST(RealTimeResults, costs_are_of_one_message_and_of_all_processes) {
  Measurement round = published({0, 1, 2, 3}, {1, 1, 1, 1});
  round.publisher.allocations = 4;
  round.subscribers.allocations = 8;
  const RealTimeFigures figures = figures_of(std::move(round));
  EXPECT_DOUBLE_EQ(figures.allocations, 3);
  EXPECT_DOUBLE_EQ(figures.page_faults, 11);  // 4 and 40 in made_up
}

TEST(RealTimeResults, other_cells_are_left_out) {
  const std::vector<CellResult> results{{{"tzc", 4096, 1}, {{0, made_up({{1}})}}},
                                        {{"tzc", 4096, 1, under_load}, {{0, made_up({{1}})}}},
                                        {in_loop, {}}};
  EXPECT_THAT(real_time_figures(results, 30), testing::IsEmpty());
  EXPECT_EQ(real_time_script({}), "");
}

TEST(RealTimeResults, the_table_ends_with_the_worst) {
  const Table table = real_time_table({figures_of(published({0, 1'000'000}, {10'000, 30'000}))});
  ASSERT_EQ(table.rows.size(), 1U);
  ASSERT_EQ(table.columns.size(), table.rows[0].size());
  EXPECT_EQ(table.columns[9], "max_us");
  EXPECT_EQ(table.rows[0][9], "30.000");
  EXPECT_EQ(table.rows[0][3], "no");
}

TEST(RealTimeResults, the_histogram_counts_every_delivery_once) {
  const std::string script = real_time_script({figures_of(published({0, 1'000'000}, {10'000, 10'100}))});
  EXPECT_THAT(script, HasSubstr("11.2202 2\n"));  // the step from 10 to 12.6 µs
  EXPECT_THAT(script, HasSubstr("title \"tzc\""));
  EXPECT_THAT(script, HasSubstr("set key at screen"));  // above the curves, which may be anywhere
}

}  // namespace
}  // namespace tzc::bench
