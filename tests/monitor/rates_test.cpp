// SPDX-License-Identifier: BSD-3-Clause
#include "rates.h"

#include <gtest/gtest.h>

#include "filter.h"

namespace tzc::monitor {
namespace {

Node sample(std::uint64_t updated_s, std::uint64_t messages) {
  Node node;
  node.name = "/camera";
  node.pid = 42;
  node.updated_ns = updated_s * 1000000000;
  Topic topic;
  topic.name = "/image";
  topic.counters.messages = messages;
  topic.counters.shared = 2 * messages;
  Connection viewer;
  viewer.subscriber = "/viewer";
  viewer.messages = messages;
  topic.connections = {viewer};
  node.topics = {topic};
  return node;
}

std::optional<Rates> rates(const std::vector<Node>& before, std::vector<Node>& now) {
  add_rates(before, now);
  return now.at(0).rates.at(0);
}

TEST(Rates, are_counted_over_the_time_between_two_updates) {
  std::vector<Node> now{sample(12, 160)};
  const auto found = rates({sample(10, 100)}, now);
  ASSERT_TRUE(found);
  EXPECT_DOUBLE_EQ(found->messages, 30);
  EXPECT_DOUBLE_EQ(found->shared, 60);
  EXPECT_EQ(now[0].topics[0].connections[0].messages_per_s, 30);
}

TEST(Rates, are_not_invented_for_what_roscpp_does_not_count) {
  Node before = sample(10, 0), after = sample(12, 0);
  for (Node* node : {&before, &after}) node->topics[0].connections[0].transport = Transport::intraprocess;
  std::vector<Node> now{after};
  rates({before}, now);
  EXPECT_FALSE(now[0].topics[0].connections[0].messages_per_s);
}

TEST(Rates, need_an_earlier_sample_of_the_same_process) {
  std::vector<Node> now{sample(12, 160)};
  EXPECT_FALSE(rates({}, now));
  Node other = sample(10, 100);
  other.pid = 43;
  EXPECT_FALSE(rates({other}, now));
  Node restarted = sample(10, 100);
  restarted.started_ns = 5;
  EXPECT_FALSE(rates({restarted}, now));
  EXPECT_FALSE(now[0].topics[0].connections[0].messages_per_s);
}

TEST(Rates, of_a_topic_that_was_advertised_anew_begin_at_zero) {
  std::vector<Node> now{sample(12, 5)};
  EXPECT_DOUBLE_EQ(rates({sample(10, 100)}, now)->messages, 0);
}

TEST(Rates, stay_until_the_next_update_while_the_process_runs) {
  std::vector<Node> second{sample(12, 160)};
  add_rates({sample(10, 100)}, second);
  std::vector<Node> third{sample(12, 160)};
  EXPECT_DOUBLE_EQ(rates(second, third)->messages, 30);
  third[0].state = State::stopped;
  EXPECT_DOUBLE_EQ(rates(second, third)->messages, 0);
}

TEST(Rates, of_a_connection_that_moved_begin_at_zero) {
  Node before = sample(10, 100);
  before.topics[0].connections[0].transport = Transport::tcpros;
  std::vector<Node> now{sample(12, 160)};
  EXPECT_TRUE(rates({before}, now));
  EXPECT_FALSE(now[0].topics[0].connections[0].messages_per_s);
}

TEST(Rates, of_a_subscription_are_counted_as_its_latencies_are) {
  Node before = sample(10, 100);
  Subscription image;
  image.topic = "/image";
  image.publisher = "/camera";
  image.messages = 10;
  image.latencies[4] = 10;
  before.subscriptions = {image};
  std::vector<Node> now{sample(12, 160)};
  image.messages = 70;
  image.latencies[4] = 50;
  image.latencies[9] = 20;
  now[0].subscriptions = {image};
  add_rates({before}, now);
  EXPECT_EQ(now[0].subscriptions[0].messages_per_s, 30);
  EXPECT_EQ(now[0].subscriptions[0].recent[4], 40U);
  EXPECT_EQ(now[0].subscriptions[0].recent[9], 20U);
  std::vector<Node> later{now[0]};  // the page was not updated in between
  later[0].subscriptions[0].recent = {};
  add_rates(now, later);
  EXPECT_EQ(later[0].subscriptions[0].recent[9], 20U);
}

TEST(Rates, tell_what_a_connection_lost_since_the_last_look) {
  Node before = sample(10, 100);
  before.topics[0].connections[0].revoked_for_queue = 5;
  std::vector<Node> now{sample(12, 160)};
  now[0].topics[0].connections[0].revoked_for_queue = 7;
  now[0].topics[0].connections[0].revoked_for_memory = 1;
  now[0].topics[0].connections[0].revoked_at_end = 9;
  add_rates({before}, now);
  const Connection& viewer = now[0].topics[0].connections[0];
  ASSERT_TRUE(viewer.lost_since);
  EXPECT_EQ(viewer.lost_since->for_queue, 2U);
  EXPECT_EQ(viewer.lost_since->for_memory, 1U);
  EXPECT_EQ(viewer.losses().sum(), 8U);
}

TEST(Filter, keeps_the_subscribers_of_a_topic) {
  Node node = sample(12, 160);
  node.topics.clear();
  Subscription image, depth;
  image.topic = "/image";
  depth.topic = "/depth";
  node.subscriptions = {depth, image};
  std::vector<Node> nodes{node};
  keep_topic("/image", nodes);
  ASSERT_EQ(nodes.size(), 1U);
  ASSERT_EQ(nodes[0].subscriptions.size(), 1U);
  EXPECT_EQ(nodes[0].subscriptions[0].topic, "/image");
  keep_topic("/other", nodes);
  EXPECT_TRUE(nodes.empty());
}

// Its page tells why they are not shared.
TEST(Filter, keeps_nodes_that_publish_the_topic_without_TZC) {
  Node viewer = sample(12, 160);
  viewer.name = "/viewer";
  viewer.topics.clear();
  Subscription raw;
  raw.topic = "/raw";
  raw.publisher = "/camera";
  viewer.subscriptions = {raw};
  Node other = sample(12, 160);
  other.name = "/other";
  std::vector<Node> nodes{sample(12, 160), other, viewer};
  keep_topic("/raw", nodes);
  ASSERT_EQ(nodes.size(), 2U);
  EXPECT_EQ(nodes[0].name, "/camera");
  EXPECT_TRUE(nodes[0].topics.empty());
  EXPECT_EQ(nodes[1].name, "/viewer");
}

TEST(Filter, keeps_a_topic_with_its_rates_and_only_nodes_that_have_it) {
  Node both = sample(12, 160), other = sample(12, 1);
  both.topics.insert(both.topics.begin(), Topic());
  both.rates = {std::nullopt, Rates{30, 0, 0, 0, 0}};
  other.topics[0].name = "/other";
  std::vector<Node> nodes{both, other};
  keep_topic("image", nodes);  // a name without its slash is meant, too
  ASSERT_EQ(nodes.size(), 1u);
  ASSERT_EQ(nodes[0].topics.size(), 1u);
  EXPECT_EQ(nodes[0].topics[0].name, "/image");
  ASSERT_TRUE(nodes[0].rates.at(0));
  EXPECT_DOUBLE_EQ(nodes[0].rates[0]->messages, 30);
}

}  // namespace
}  // namespace tzc::monitor
