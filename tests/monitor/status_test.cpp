// SPDX-License-Identifier: BSD-3-Clause
#include "diagnostics/status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tzc::monitor {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using testing::HasSubstr;

Node viewed_camera() {
  Connection viewer;
  viewer.subscriber = "/viewer";
  viewer.transport = Transport::shared;
  viewer.pid = 77;
  Topic image;
  image.name = "/image";
  image.counters.messages = 12;
  image.connections = {viewer};
  Node node;
  node.name = "/camera";
  node.pid = 42;
  node.topics = {image};
  return node;
}

TEST(Status, of_a_node_without_problems_is_ok) {
  const auto all = statuses({viewed_camera()}, "robot");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].name, "tzc: /camera");
  EXPECT_EQ(all[0].level, DiagnosticStatus::OK);
  EXPECT_EQ(all[0].message, "OK");
  EXPECT_EQ(all[0].hardware_id, "robot");
  ASSERT_EQ(all[0].values.size(), 1U);
  EXPECT_EQ(all[0].values[0].key, "/image");
  EXPECT_THAT(all[0].values[0].value, HasSubstr("12 messages"));
}

TEST(Status, is_the_worst_problem_and_names_all) {
  Node node = viewed_camera();
  Connection rviz;
  rviz.subscriber = "/rviz";
  rviz.transport = Transport::tcpros;
  rviz.reason = "it has no TZC";
  node.topics[0].connections.push_back(rviz);
  node.topics[0].counters.exhausted = 3;
  const auto all = statuses({node}, "robot");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].level, DiagnosticStatus::WARN);
  EXPECT_THAT(all[0].message, HasSubstr("no shared memory"));
  ASSERT_EQ(all[0].values.size(), 3U);
  EXPECT_EQ(all[0].values[2].key, "TCPROS");
}

TEST(Status, of_a_stopped_subscriber_is_an_error_of_its_own) {
  Node node = viewed_camera();
  node.topics[0].connections[0].is_stopped = true;
  const auto all = statuses({node}, "robot");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].level, DiagnosticStatus::OK);
  EXPECT_EQ(all[1].name, "tzc: /viewer");
  EXPECT_EQ(all[1].level, DiagnosticStatus::ERROR);
}

TEST(Status, has_what_each_subscription_counts) {
  Subscription shared, plain;
  shared.topic = plain.topic = "/image";
  shared.publisher = "/camera";
  shared.transport = Transport::shared;
  shared.messages = 12;
  shared.latencies[6] = 12;  // below 66 us
  shared.held_messages = 2;
  shared.lost = 3;
  plain.publisher = "/unported";
  plain.transport = Transport::tcpros;
  plain.messages = 7;
  Node viewer;
  viewer.name = "/viewer";
  viewer.subscriptions = {shared, plain};
  const auto values = [&] { return statuses({viewer}, "robot").at(0).values; };
  EXPECT_EQ(values().at(0).key, "/image from /camera");
  EXPECT_EQ(values().at(0).value, "12 messages over shared, latency < 66 us (99%: < 66 us), holds 2, lost 3");
  EXPECT_EQ(values().at(1).value, "7 messages over TCPROS");
  viewer.subscriptions[0].latencies = {};
  EXPECT_EQ(values().at(0).value, "12 messages over shared, latency -, holds 2, lost 3");
}

TEST(Status, of_a_subscription_that_stays_on_tcpros_is_ok_and_names_it) {
  Node viewer;
  viewer.name = "/viewer";
  viewer.subscriptions.resize(1);
  viewer.subscriptions[0].topic = "/image";
  viewer.subscriptions[0].publisher = "/unported";
  viewer.subscriptions[0].transport = Transport::tcpros;
  const auto all = statuses({viewer}, "robot");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].level, DiagnosticStatus::OK);
  ASSERT_EQ(all[0].values.size(), 2U);
  EXPECT_EQ(all[0].values[1].key, "TCPROS");
  EXPECT_THAT(all[0].values[1].value, HasSubstr("/viewer gets /image from /unported over TCPROS"));
}

TEST(Status, of_a_connection_that_stays_on_tcpros_is_ok) {
  Node node = viewed_camera();
  node.topics[0].connections[0].transport = Transport::tcpros;
  node.topics[0].connections[0].reason = "it has no TZC";
  EXPECT_EQ(statuses({node}, "robot")[0].level, DiagnosticStatus::OK);
}

}  // namespace
}  // namespace tzc::monitor
