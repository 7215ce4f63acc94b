// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "json_report.h"
#include "screen.h"
#include "table.h"

namespace tzc::monitor {
namespace {

using testing::HasSubstr;
using testing::Not;

Node camera() {
  Connection shared, plain;
  shared.subscriber = "/viewer";
  shared.transport = Transport::shared;
  shared.messages = 60;
  shared.messages_per_s = 30;
  shared.in_flight = 1;
  shared.held = 2;
  shared.pid = 77;
  plain.subscriber = "/rviz";
  plain.transport = Transport::tcpros;
  plain.reason = "it has no TZC";
  Topic topic;
  topic.name = "/image";
  topic.type = "sensor_msgs/Image";
  topic.memory.used = 3 << 20;
  topic.counters.exhausted = 4;
  topic.connections = {shared, plain};
  Node node;
  node.name = "/camera";
  node.pid = 42;
  node.topics = {topic};
  node.rates = {Rates{30, 60, 0, 1 << 20}};
  return node;
}

TEST(Table, has_a_line_for_each_node_topic_and_connection) {
  EXPECT_EQ(table({camera()}, false),
            "  TOPIC   TYPE                 MSG/S  SHARED/S  SERIAL/S  COPIED/S    USED  COMMITTED    SIZE  "
            "EXHAUSTED  "
            "DROPPED  REVOKED\n"
            "/camera  process 42  running\n"
            "  /image  sensor_msgs/Image     30.0      60.0       0.0      1.0M    3.0M          0       0   "
            "       4  "
            "      0        0\n"
            "    -> /viewer  shared         30.0/s  sent 60, in flight 1, holds 2, revoked 0\n"
            "    -> /rviz    TCPROS              -  sent 0: it has no TZC\n");
}

TEST(Table, without_a_second_sample_has_no_rates) {
  Node node = camera();
  node.rates.clear();
  EXPECT_THAT(table({node}, false), HasSubstr("sensor_msgs/Image        -         -         -         -"));
}

TEST(Table, says_what_is_stopped) {
  Node node = camera();
  node.state = State::stopped;
  node.age_s = 3.2;
  node.topics[0].connections[0].is_stopped = true;
  EXPECT_THAT(table({node}, false), HasSubstr("process 42  stopped, as of 3 s ago\n"));
  EXPECT_THAT(table({node}, false), HasSubstr("revoked 0  stopped\n"));
}

TEST(Table, has_colours_only_on_demand) {
  EXPECT_THAT(table({camera()}, true), HasSubstr("\x1b[32mshared    \x1b[0m"));
  EXPECT_THAT(table({camera()}, false), Not(HasSubstr("\x1b")));
}

TEST(Json, has_the_numbers_as_they_are) {
  const auto report = nlohmann::json::parse(json_report({camera()}));
  EXPECT_EQ(report["version"], 1);
  const auto& topic = report["nodes"][0]["topics"][0];
  EXPECT_EQ(report["nodes"][0]["state"], "running");
  EXPECT_EQ(topic["memory"]["used"], 3 << 20);
  EXPECT_EQ(topic["per_second"]["messages"], 30.0);
  EXPECT_EQ(topic["connections"][0]["held"], 2);
  EXPECT_EQ(topic["connections"][0]["pid"], 77);
  EXPECT_TRUE(topic["connections"][1]["pid"].is_null());
  EXPECT_EQ(topic["connections"][1]["reason"], "it has no TZC");
}

TEST(Json, has_no_rates_of_one_sample) {
  Node node = camera();
  node.rates.clear();
  EXPECT_TRUE(nlohmann::json::parse(json_report({node}))["nodes"][0]["topics"][0]["per_second"].is_null());
}

TEST(Screen, cuts_what_does_not_fit) {
  EXPECT_EQ(fitted("one\ntwo\n", 5, 80), "one\x1b[K\r\ntwo\x1b[K");
  EXPECT_EQ(fitted("abcdef\n", 5, 3), "abc\x1b[K");
  EXPECT_EQ(fitted("\x1b[31mabcdef\x1b[0m\n", 5, 3), "\x1b[31mabc\x1b[0m\x1b[K");
  EXPECT_EQ(fitted("1\n2\n3\n4\n", 3, 80),
            "1\x1b[K\r\n2\x1b[K\r\n... 2 more lines: see --topic and --once\x1b[K");
}

}  // namespace
}  // namespace tzc::monitor
