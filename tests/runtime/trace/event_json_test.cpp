// SPDX-License-Identifier: BSD-3-Clause
#include "trace/event_json.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <vector>

#include "trace/names.h"

namespace tzc {
namespace trace {
namespace {

using nlohmann::json;

std::vector<json> parsed(const std::string& lines) {
  std::istringstream stream(lines);
  std::vector<json> events;
  for (std::string line; std::getline(stream, line);) {
    EXPECT_EQ(line.back(), ',');
    line.pop_back();
    events.push_back(json::parse(line));
  }
  return events;
}

TEST(EventJson, a_step_is_a_slice_and_a_point_of_its_flow) {
  const auto events = parsed(
      to_json({1234567, 1240000, 0xabcd00000007, 345, "/image", 99, Step::publish, Arrow::begins}, 42));
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0],
            json::parse(R"({"ph": "X", "cat": "publish", "name": "publish /image", "pid": 42, "tid": 99,
      "ts": 1234.567, "dur": 5.433, "args": {"message": "0x0000abcd00000007", "bytes": 345}})"));
  EXPECT_EQ(events[1],
            json::parse(R"({"ph": "s", "cat": "message", "name": "message", "id": "0x0000abcd00000007",
      "pid": 42, "tid": 99, "ts": 1234.567})"));
}

TEST(EventJson, the_end_of_a_flow_binds_to_the_slice_around_it) {
  const auto events = parsed(to_json({1000, 2000, 7, 0, "/image", 99, Step::callback, Arrow::ends}, 42));
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[1]["ph"], "f");
  EXPECT_EQ(events[1]["bp"], "e");
}

TEST(EventJson, a_message_that_the_other_end_does_not_know_has_no_flow) {
  EXPECT_EQ(parsed(to_json({1000, 2000, 0, 0, "/image", 99, Step::callback, Arrow::ends}, 42)).size(), 1U);
}

TEST(EventJson, a_clock_that_went_back_gives_no_negative_time) {
  EXPECT_EQ(parsed(to_json({2000, 1000, 7, 0, "/image", 99, Step::wake, Arrow::none}, 42))[0]["dur"], 0.0);
}

TEST(EventJson, any_name_gives_json) {
  const std::string odd = "a\"b\\c\n\x01\xff/" + std::string(5000, 'x');
  const auto events = parsed(to_json({1, 2, 7, 0, odd.c_str(), 99, Step::take, Arrow::passes}, 42));
  EXPECT_EQ(events[0]["name"].get<std::string>().substr(0, 16),
            "take a\"b\\c??"
            "?/xx");  // in two: ??/ is a trigraph
  EXPECT_EQ(parsed(process_name(42, odd)).size(), 1U);
  EXPECT_EQ(parsed(thread_name(42, 99, odd)).size(), 1U);
}

TEST(EventJson, dropped_events_are_a_counter) {
  const auto events = parsed(dropped_count(42, 5000, 17));
  EXPECT_EQ(events[0]["ph"], "C");
  EXPECT_EQ(events[0]["args"]["events"], 17);
}

TEST(FileName, has_the_number_of_the_process) {
  EXPECT_EQ(file_name("/tmp/trace.json", 42), "/tmp/trace.json.42");
  EXPECT_EQ(file_name("/tmp/%p/trace.%p.json", 42), "/tmp/42/trace.42.json");
}

}  // namespace
}  // namespace trace
}  // namespace tzc
