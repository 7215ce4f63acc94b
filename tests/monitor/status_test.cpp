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
  EXPECT_THAT(all[0].message, HasSubstr("no shared memory left"));
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

TEST(Status, of_a_connection_that_stays_on_tcpros_is_ok) {
  Node node = viewed_camera();
  node.topics[0].connections[0].transport = Transport::tcpros;
  node.topics[0].connections[0].reason = "it has no TZC";
  EXPECT_EQ(statuses({node}, "robot")[0].level, DiagnosticStatus::OK);
}

}  // namespace
}  // namespace tzc::monitor
