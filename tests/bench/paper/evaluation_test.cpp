// SPDX-License-Identifier: BSD-3-Clause
#include "paper/evaluation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "made_up.h"
#include "temp_dir.h"

namespace {

using namespace tzc::bench;
using testing::ElementsAre;
using testing::IsEmpty;
using tzc::test::made_up;
using tzc::test::TempDir;

/// Measures nothing: says what it was asked for, and ends the run at the given call.
class Measurements {
 public:
  std::vector<std::string> asked;
  std::size_t end_at = 1000;
  Outcome end = Outcome::interrupted;

  MeasureCell function() {
    return [this](const Cell& cell, std::size_t count) {
      asked.push_back(cell.contender + " " + std::to_string(count));
      Measurement round = made_up({std::vector<std::uint64_t>(count, 1000)});
      if (asked.size() == end_at) round.outcome = end;
      return round;
    };
  }
};

struct Evaluation : testing::Test {
  Evaluation() {
    options.rate = 10;
    options.count = 5;
    options.rounds = 2;
    store.begin({{"begun", "now"},
                 {"settings", 1},
                 {"machine", {{"cpu", "a <b> & c"}}},
                 {"versions", {{"tzc", "1"}}}});
  }
  Progress run() { return measure_missing(options, cells, store, measurements.function()); }

  TempDir folder;
  Store store{folder.path()};
  Options options;
  std::vector<Cell> cells{{"a", 4096, 1}, {"b", 4096, 1}};
  Measurements measurements;
};

TEST_F(Evaluation, lets_the_contenders_take_turns) {
  EXPECT_EQ(run(), Progress::complete);
  EXPECT_THAT(measurements.asked, ElementsAre("a 2", "b 2", "a 3", "b 3"));
}

TEST_F(Evaluation, measures_nothing_twice) {
  run();
  measurements.asked.clear();
  EXPECT_EQ(run(), Progress::complete);
  EXPECT_THAT(measurements.asked, IsEmpty());
}

TEST_F(Evaluation, goes_on_where_it_was_interrupted) {
  measurements.end_at = 3;
  EXPECT_EQ(run(), Progress::interrupted);
  measurements.asked.clear();
  measurements.end_at = 1000;
  EXPECT_EQ(run(), Progress::complete);
  EXPECT_THAT(measurements.asked, ElementsAre("a 3", "b 3"));
}

TEST_F(Evaluation, tries_what_failed_again_and_keeps_the_rest) {
  measurements.end_at = 2;
  measurements.end = Outcome::failed;
  EXPECT_EQ(run(), Progress::with_failures);
  measurements.asked.clear();
  measurements.end_at = 1000;
  EXPECT_EQ(run(), Progress::complete);
  EXPECT_THAT(measurements.asked, ElementsAre("b 2"));
}

TEST_F(Evaluation, measures_cells_that_are_new) {
  run();
  measurements.asked.clear();
  cells.push_back({"c", 4096, 1});
  run();
  EXPECT_THAT(measurements.asked, ElementsAre("c 2", "c 3"));
}

TEST_F(Evaluation, leaves_no_round_without_a_message) {
  options.count = 1;
  run();
  EXPECT_THAT(measurements.asked, ElementsAre("a 1", "b 1"));
}

TEST_F(Evaluation, tells_how_much_time_is_left) {
  testing::internal::CaptureStderr();
  run();
  const std::string said = testing::internal::GetCapturedStderr();
  EXPECT_THAT(said, testing::ContainsRegex("\\[1/4\\] a, .*; 1 minute left\n"));
  EXPECT_THAT(said, testing::ContainsRegex("\\[4/4\\] b, [^;]*µs\n"));
}

TEST_F(Evaluation, reports_the_cells_that_it_has) {
  measurements.end_at = 2;
  run();
  write_reports(options, cells, store, false);
  EXPECT_THAT(folder.read("reliability.csv"), testing::EndsWith("\na,4096,1,0,2,2,1.000000\n"));
  EXPECT_THAT(folder.read("latency.csv"), testing::Not(testing::HasSubstr("\nb,")));
}

TEST_F(Evaluation, leaves_no_table_of_a_section_that_is_gone) {
  run();
  write_reports(options, cells, store, false, {effort_section({{"package", "lines"}, {{"camera", "3"}}})});
  EXPECT_THAT(folder.read("effort.csv"), testing::HasSubstr("camera,3"));
  write_reports(options, cells, store, false, {effort_section({{"package", "lines"}, {}})});
  EXPECT_FALSE(std::filesystem::exists(store.path_of("effort.csv")));
}

TEST_F(Evaluation, leaves_no_plot_that_it_has_not_drawn) {
  run();
  for (const char* name : {"latency-1.svg", "latency-1.png", "latency-8-load.gnuplot", "real-time.svg"})
    folder.write(name, "of an earlier run");
  folder.write("latency-of-mine.svg", "the user's");
  write_reports(options, cells, store, false);
  for (const char* name : {"latency-1.svg", "latency-1.png", "latency-8-load.gnuplot", "real-time.svg"})
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.read("latency-of-mine.svg"), "the user's");
  EXPECT_THAT(folder.read("latency.csv"), testing::HasSubstr("\na,"));
}

TEST_F(Evaluation, shows_texts_of_the_machine_as_texts) {
  run();
  write_reports(options, cells, store, false);
  EXPECT_THAT(folder.read("index.html"), testing::HasSubstr("a &lt;b&gt; &amp; c"));
}

}  // namespace
