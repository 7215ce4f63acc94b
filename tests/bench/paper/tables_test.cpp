// SPDX-License-Identifier: BSD-3-Clause
#include "paper/tables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_up.h"

namespace {

using namespace tzc::bench;
using testing::ElementsAre;
using tzc::test::made_up;

// Two subscribers, two rounds: one message of the second subscriber is lost.
CellResult two_rounds() {
  return {{"tcpros", 100, 2}, {{0, made_up({{1000, 2000}, {3000, 0}})}, {1, made_up({{5000}, {4000}})}}};
}

TEST(Summary, counts_over_all_rounds) {
  const Summary summary = summarize(two_rounds(), 10);
  EXPECT_EQ(summary.sent, 3u);
  EXPECT_THAT(summary.delivered, ElementsAre(3, 2));
  EXPECT_EQ(summary.latency_us->count, 5u);
  EXPECT_DOUBLE_EQ(summary.latency_us->median, 3);
  EXPECT_DOUBLE_EQ(worst_share(summary), 2.0 / 3);
  EXPECT_DOUBLE_EQ(mean_share(summary), 5.0 / 6);
}

TEST(Summary, says_whether_the_publisher_held_the_rate) {
  EXPECT_DOUBLE_EQ(summarize(two_rounds(), 10).rate, 10);
  EXPECT_TRUE(summarize(two_rounds(), 10.5).holds_rate);
  EXPECT_FALSE(summarize(two_rounds(), 10.6).holds_rate);
}

// 660 bytes in each of two rounds, 3 messages of 100 bytes.
TEST(Summary, counts_every_byte_that_was_moved) {
  EXPECT_DOUBLE_EQ(copies_per_message(summarize(two_rounds(), 10)), 1320.0 / 300);
}

TEST(Summary, of_a_cell_without_deliveries_has_no_latency) {
  const Summary summary = summarize({{"ach", 100, 1}, {{0, made_up({{0, 0}})}}}, 10);
  EXPECT_FALSE(summary.latency_us.has_value());
  EXPECT_EQ(worst_share(summary), 0);
  EXPECT_THAT(latency_table({summary}).rows.front(),
              ElementsAre("ach", "100", "1", "10.000", "yes", "0.000000", "", "", "", "", "", "", "", ""));
}

TEST(Table, has_a_row_of_its_own_for_each_subscriber) {
  EXPECT_THAT(reliability_table({summarize(two_rounds(), 10)}).rows,
              ElementsAre(ElementsAre("tcpros", "100", "2", "0", "3", "3", "1.000000"),
                          ElementsAre("tcpros", "100", "2", "1", "3", "2", "0.666667")));
}

TEST(Table, tells_costs_of_one_message) {
  EXPECT_THAT(copies_table({summarize(two_rounds(), 10)}).rows,
              ElementsAre(ElementsAre("tcpros", "100", "2", "4.400", "200.000", "66.667", "2.667", "13.333",
                                      "20.000", "26.667")));
}

TEST(Table, has_as_many_fields_in_each_row_as_columns) {
  const std::vector<Summary> summaries{summarize(two_rounds(), 10)};
  for (const Table& table : {latency_table(summaries), reliability_table(summaries), copies_table(summaries)})
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

TEST(Csv, quotes_what_would_end_a_field) {
  EXPECT_EQ(to_csv({{"a", "b"}, {{"", "x"}, {"1,5", "say \"hi\""}, {"two\nlines", ""}}}),
            "a,b\n,x\n\"1,5\",\"say \"\"hi\"\"\"\n\"two\nlines\",\n");
}

TEST(SizeText, is_short) {
  EXPECT_EQ(size_text(100), "100 B");
  EXPECT_EQ(size_text(4096), "4 KB");
  EXPECT_EQ(size_text(3 << 19), "1.5 MB");
  EXPECT_EQ(size_text(64 << 20), "64 MB");
}

}  // namespace
