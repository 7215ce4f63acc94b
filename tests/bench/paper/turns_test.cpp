// SPDX-License-Identifier: BSD-3-Clause
#include "paper/turns.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "made_up.h"

namespace {

using namespace tzc::bench;
using tzc::test::made_up;

Options of(std::size_t messages, std::size_t rounds) {
  Options options;
  options.rate = 10;
  options.count = messages;
  options.rounds = rounds;
  return options;
}

/// A measurement of five messages that took so long.
Measurement taking(double seconds) {
  Measurement round = made_up({std::vector<std::uint64_t>(5, 1000)});
  round.seconds = seconds;
  return round;
}

struct Turns : testing::Test {
  std::vector<CellResult> results{{{"a", 4096, 1}, {}}, {{"b", 4096, 1}, {}}};
  const Options options = of(10, 2);
};

TEST_F(Turns, are_those_that_the_results_lack) {
  results[1].rounds.emplace(0, taking(1));
  std::vector<std::string> text;
  for (const Turn& turn : turns_of(options, results))
    text.push_back(turn.cell->contender + std::to_string(turn.round) + ":" + std::to_string(turn.count));
  EXPECT_THAT(text, testing::ElementsAre("a0:5", "a1:5", "b1:5"));
}

// 20 messages of the warm-up and 5 at 10 Hz, and 2 s around them.
TEST_F(Turns, take_as_long_as_the_rate_says_before_any_was_measured) {
  EXPECT_DOUBLE_EQ(Timetable(10, results).seconds_of(turns_of(options, results).front()), 4.5);
}

TEST_F(Turns, take_as_long_as_earlier_messages_of_the_same_cell) {
  results[1].rounds.emplace(0, taking(10));
  const std::vector<Turn> turns = turns_of(options, results);
  const Timetable timetable(10, results);
  EXPECT_DOUBLE_EQ(timetable.seconds_of(turns[0]), 4.5);
  EXPECT_DOUBLE_EQ(timetable.seconds_of(turns[2]), 52);
}

TEST_F(Turns, have_around_them_what_those_of_this_run_had) {
  const std::vector<Turn> turns = turns_of(options, results);
  Timetable timetable(10, results);
  timetable.add(turns[0], taking(0.5), 6.5);
  timetable.add(turns[1], taking(1), 11);
  EXPECT_DOUBLE_EQ(timetable.seconds_of(turns[2]), 2.5 + 5);
  EXPECT_DOUBLE_EQ(timetable.seconds_from(2, turns), 7.5 + 10);
  EXPECT_DOUBLE_EQ(timetable.seconds_from(4, turns), 0);
}

TEST(Duration, is_in_minutes_rounded_up) {
  EXPECT_EQ(duration_text(0), "1 minute");
  EXPECT_EQ(duration_text(61), "2 minutes");
  EXPECT_EQ(duration_text(3 * 3600 + 59), "3 h 01 min");
}

}  // namespace
