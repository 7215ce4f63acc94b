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
  shared.oldest_held_s = 4.4;
  shared.shared_bytes_per_s = 30 << 20;
  shared.revoked = 3;
  shared.revoked_for_queue = 2;
  shared.revoked_at_end = 1;
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
  node.rates = {Rates{30, 60, 0, 1 << 20, 0}};
  return node;
}

Node viewer() {
  Subscription image;
  image.topic = "/image";
  image.publisher = "/camera";
  image.transport = Transport::shared;
  image.messages_per_s = 30;
  image.held_messages = 2;
  image.held_bytes = 12 << 20;
  image.lost = 3;
  image.latencies[6] = 98;  // below 65 us
  image.latencies[11] = 2;  // below 2.1 ms
  image.pid = 42;
  Node node;
  node.name = "/viewer";
  node.pid = 77;
  node.subscriptions = {image};
  return node;
}

TEST(Table, has_a_line_for_each_node_topic_and_connection) {
  EXPECT_EQ(
      table({camera(), viewer()}, false),
      "2 nodes, 2 connections (1 shared, 1 TCPROS). 2 problems: 1 lost, 1 TCPROS.\n"
      "\n"
      "PROBLEMS\n"
      "  lost     /viewer did not take 2 messages of /image from /camera in time: its queue was full.\n"
      "  TCPROS   /camera sends /image to /rviz over TCPROS: it has no TZC.\n"
      "\n"
      "  TOPIC    MSG/S  SERIAL/S   SAVED/S  COPIED/S    USED    PEAK    SIZE  NO MEM    LOST  TYPE\n"
      "/camera  process 42  running\n"
      "  /image    30.0       0.0     30.0M      1.0M    3.0M       0       0       4       0  "
      "sensor_msgs/Image\n"
      "    -> /viewer              shared        30.0/s  in flight 1, holds 2 for up to 4 s, lost 3: 2 queue "
      "full 1 at its end\n"
      "    -> /rviz                TCPROS             -  it has no TZC\n"
      "/viewer  process 77  running\n"
      "    <- /image from /camera  shared        30.0/s  latency < 66 us (99%: < 2.1 ms), holds 2 (12.0M), "
      "lost 3\n");
}

TEST(Table, shows_the_latencies_since_the_last_look_when_there_are_any) {
  Node node = viewer();
  node.subscriptions[0].recent[3] = 5;
  EXPECT_THAT(table({node}, false), HasSubstr("latency < 8 us (99%: < 8 us)"));
  node.subscriptions[0].recent = {};
  node.subscriptions[0].latencies = {};
  EXPECT_THAT(table({node}, false), HasSubstr("latency -, "));
}

TEST(Table, without_problems_has_no_list_of_them) {
  Node node = viewer();
  EXPECT_THAT(table({node}, false), Not(HasSubstr("PROBLEMS")));
  EXPECT_THAT(table({node}, false),
              testing::StartsWith("1 node, 1 connection (1 shared). No problem.\n\n  TOPIC"));
}

TEST(Table, counts_subscriptions_that_no_publisher_tells_of) {
  Node node = viewer();
  node.subscriptions.push_back(node.subscriptions[0]);
  node.subscriptions[1].publisher = "/unported";
  node.subscriptions[1].transport = Transport::tcpros;
  EXPECT_THAT(
      table({node}, false),
      testing::StartsWith("1 node, 2 connections (1 shared, 1 TCPROS). 1 problem: 1 TCPROS.\n\nPROBLEMS\n"
                          "  TCPROS   /viewer gets /image from /unported over TCPROS: "));
}

TEST(Table, fits_a_terminal_of_100_columns_up_to_the_type) {
  Node node = camera();
  node.topics[0].name = "/camera/image_raw";
  const std::string text = table({node}, false);
  const std::size_t head = text.find("  TOPIC");
  EXPECT_LE(text.find("TYPE") - head, 100U);
}

TEST(Table, without_a_second_sample_has_no_rates) {
  Node node = camera();
  node.rates.clear();
  EXPECT_THAT(table({node}, false), HasSubstr("/image       -         -     30.0M         -"));
}

TEST(Table, says_what_is_stopped) {
  Node node = camera();
  node.state = State::stopped;
  node.age_s = 3.2;
  node.topics[0].connections[0].is_stopped = true;
  EXPECT_THAT(table({node}, false), HasSubstr("process 42  stopped, as of 3 s ago\n"));
  EXPECT_THAT(table({node}, false), HasSubstr("1 at its end  stopped\n"));
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
  EXPECT_EQ(topic["connections"][0]["revoked_by_cause"],
            (nlohmann::json{{"queue_full", 2}, {"memory_needed", 0}, {"subscriber_left", 1}}));
  EXPECT_EQ(topic["connections"][0]["oldest_held_s"], 4.4);
  EXPECT_EQ(report["problems"][0]["kind"], "lost");
}

TEST(Json, has_subscriptions_with_their_latencies) {
  const auto report = nlohmann::json::parse(json_report({viewer()}));
  const auto& one = report["nodes"][0]["subscriptions"][0];
  EXPECT_EQ(one["publisher"], "/camera");
  ASSERT_EQ(one["latency"].size(), 2U);
  EXPECT_EQ(one["latency"][0]["messages"], 98);
  EXPECT_NEAR(one["latency"][0]["below_us"].get<double>(), 65.5, 0.1);
  EXPECT_TRUE(one["latency_since_last_look"].empty());
}

TEST(Json, has_no_rates_of_one_sample) {
  Node node = camera();
  node.rates.clear();
  EXPECT_TRUE(nlohmann::json::parse(json_report({node}))["nodes"][0]["topics"][0]["per_second"].is_null());
}

TEST(Screen, keeps_columns_where_a_line_is_continued) {
  EXPECT_EQ(fitted("  stopped  a.  b \n    -> /viewer  \x1b[32mshared    \x1b[0m  0.0/s  one two\n", 5, 36),
            "  stopped  a.  b \x1b[K\r\n"
            "    -> /viewer  \x1b[32mshared    \x1b[0m  0.0/s\x1b[K\r\n  one two\x1b[K");
}

TEST(Screen, cuts_what_does_not_fit) {
  EXPECT_EQ(fitted("one\ntwo\n", 5, 80), "one\x1b[K\r\ntwo\x1b[K");
  EXPECT_EQ(fitted("abcdef\n", 5, 3), "abc\x1b[K");
  EXPECT_EQ(fitted("\x1b[31mabcdef\x1b[0m\n", 5, 3), "\x1b[31mabc\x1b[0m\x1b[K");
  EXPECT_EQ(fitted("    -> /viewer  TCPROS  one two three\n", 5, 20),
            "    -> /viewer\x1b[K\r\n  TCPROS  one two\x1b[K\r\n  three\x1b[K");
  EXPECT_EQ(fitted("1\n2\n3\n4\n", 3, 80),
            "1\x1b[K\r\n2\x1b[K\r\n... 2 more lines: see --topic and --once\x1b[K");
}

}  // namespace
}  // namespace tzc::monitor
