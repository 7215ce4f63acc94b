// SPDX-License-Identifier: BSD-3-Clause
#include "channel/inspection.h"

#include <gtest/gtest.h>

#include <numeric>

#include "support.h"

namespace tzc {
namespace channel {
namespace {

using test::eventually;
using test::filled;
using test::idle_subscriber;
using test::Inbox;
using test::mb;
using test::publisher;
using test::text_record;

std::uint64_t sum(const LatencyCounts& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

TEST(LatencyBucket, is_the_power_of_two_above_the_latency) {
  EXPECT_EQ(latency_bucket(0), 0U);
  EXPECT_EQ(latency_bucket(1), 1U);
  EXPECT_EQ(latency_bucket(2), 2U);
  EXPECT_EQ(latency_bucket(3), 2U);
  EXPECT_EQ(latency_bucket(1024), 11U);
  EXPECT_EQ(latency_bucket(0xffffffff), latency_buckets - 1);
}

TEST(Inspection, of_a_subscriber_has_a_latency_for_each_message) {
  const auto camera = publisher();
  const auto viewer = idle_subscriber(camera->address());
  const auto quick = text_record("quick"), slow = text_record("slow", {filled(*camera->memory(), mb, 1)});
  ASSERT_TRUE(eventually([&] { return camera->publish(quick) == 1; }));
  camera->publish(slow);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_TRUE(viewer->read());
  ASSERT_TRUE(viewer->read());
  const SubscriberInspection seen = inspect(*viewer);
  EXPECT_EQ(sum(seen.latencies), 2U);
  for (std::size_t i = 0; i < latency_bucket(19000); ++i) EXPECT_EQ(seen.latencies[i], 0U) << i;
  EXPECT_EQ(seen.shared_bytes, mb);
}

TEST(Inspection, of_a_connection_tells_what_is_held_and_why_messages_were_dropped) {
  const auto camera = publisher(2);
  Inbox viewer(camera->address());
  const auto idle = idle_subscriber(camera->address());
  ASSERT_TRUE(eventually([&] { return camera->connections().size() == 2; }));
  for (int i = 0; i < 5; ++i) {
    camera->publish(text_record("image", {filled(*camera->memory(), mb / 4, 1)}));
    ASSERT_TRUE(viewer.wait_for(static_cast<std::size_t>(i) + 1));
  }
  const auto connections = camera->connections();
  const ConnectionInspection keeps = inspect(*connections[0]), reads_nothing = inspect(*connections[1]);
  EXPECT_EQ(keeps.held.size(), 5U);
  EXPECT_EQ(keeps.held.size(), connections[0]->held());
  EXPECT_EQ(keeps.shared_bytes, 5 * mb / 4);
  EXPECT_EQ(keeps.dropped_for_queue, 0U);
  EXPECT_TRUE(reads_nothing.held.empty());
  EXPECT_EQ(reads_nothing.dropped_for_queue, 3U);
  EXPECT_EQ(reads_nothing.dropped_for_memory + reads_nothing.dropped_at_end, 0U);
}

TEST(Inspection, tells_what_best_effort_took_back_and_what_was_left_at_the_end) {
  const auto camera = publisher(10, mb, Policy::best_effort());
  auto idle = idle_subscriber(camera->address());
  ASSERT_TRUE(eventually([&] { return camera->connections().size() == 1; }));
  const ConnectionPtr connection = camera->connections()[0];
  for (int i = 0; i < 4; ++i) camera->publish(text_record("image", {filled(*camera->memory(), mb / 3, 1)}));
  EXPECT_GE(inspect(*connection).dropped_for_memory, 1U);
  EXPECT_EQ(inspect(*connection).dropped_for_queue, 0U);
  idle.reset();
  ASSERT_TRUE(eventually([&] { return !connection->alive(); }));
  const ConnectionInspection seen = inspect(*connection);
  EXPECT_GE(seen.dropped_at_end, 1U);
  EXPECT_EQ(seen.dropped_for_memory + seen.dropped_at_end, connection->stats().dropped);
}

}  // namespace
}  // namespace channel
}  // namespace tzc
