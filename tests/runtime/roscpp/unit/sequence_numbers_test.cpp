// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/sequence_numbers.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <deque>
#include <limits>
#include <random>

namespace tzc {
namespace detail {
namespace {

/// roscpp's side: a count, and a queue whose messages are numbered when they are worked off.
class Publication {
 public:
  std::uint32_t publish(bool has_bytes) {
    const void* bytes = has_bytes ? next_bytes() : nullptr;
    const SequenceNumbers::Taken taken = numbers.take(bytes, count);
    if (taken.counts_now) ++count;
    if (bytes) queue.push_back(bytes);
    return taken.number;
  }
  /// By reference: bytes alone, the transport does not see them until they are worked off.
  const void* publish_bytes() {
    queue.push_back(next_bytes());
    return queue.back();
  }
  std::uint32_t work_off() {
    const void* bytes = queue.front();
    queue.pop_front();
    const std::uint32_t number = count++;
    count += static_cast<std::uint32_t>(numbers.numbered(bytes));
    return number;
  }

  SequenceNumbers numbers;
  std::deque<const void*> queue;
  std::uint32_t count = 0;

 private:
  const void* next_bytes() { return reinterpret_cast<const void*>(++address_ * 16); }
  std::uintptr_t address_ = 0;
};

TEST(SequenceNumbers, pointers_alone_count_at_once) {
  Publication topic;
  for (std::uint32_t i = 0; i < 5; ++i) EXPECT_EQ(topic.publish(false), i);
  EXPECT_EQ(topic.count, 5u);
}

TEST(SequenceNumbers, counts_ahead_what_waits_in_the_queue) {
  Publication topic;
  EXPECT_EQ(topic.publish(true), 0u);
  EXPECT_EQ(topic.publish(false), 1u);
  EXPECT_EQ(topic.publish(true), 2u);
  EXPECT_EQ(topic.publish(false), 3u);
  EXPECT_EQ(topic.work_off(), 0u) << "the same number on both ways";
  EXPECT_EQ(topic.work_off(), 2u) << "roscpp's count has skipped the pointer";
  EXPECT_EQ(topic.publish(false), 4u);
}

TEST(SequenceNumbers, follows_a_queue_that_was_there_before) {
  Publication topic;
  const void* first = topic.publish_bytes();
  const void* second = topic.publish_bytes();
  topic.numbers.follow({first, second});
  EXPECT_EQ(topic.publish(false), 2u);
  EXPECT_EQ(topic.work_off(), 0u);
  EXPECT_EQ(topic.work_off(), 1u);
  EXPECT_EQ(topic.count, 3u);
  topic.numbers.follow({});
  EXPECT_EQ(topic.publish(false), 3u);
}

TEST(SequenceNumbers, following_twice_counts_nothing_twice) {
  Publication topic;
  const void* first = topic.publish_bytes();
  topic.numbers.follow({first});
  topic.numbers.follow({first});
  EXPECT_EQ(topic.publish(false), 1u);
}

// Something threw while roscpp published them.
TEST(SequenceNumbers, bytes_that_never_came_into_the_queue_are_forgotten) {
  Publication topic;
  EXPECT_EQ(topic.publish(true), 0u);
  EXPECT_EQ(topic.publish(false), 1u);
  topic.queue.clear();
  EXPECT_EQ(topic.publish(true), 2u);
  topic.work_off();
  EXPECT_EQ(topic.numbers.queued(), 0u);
  const std::uint32_t number = topic.publish(false);
  EXPECT_EQ(number + 1, topic.count) << "it counts at once, as nothing waits";
}

TEST(SequenceNumbers, follows_what_stands_before_what_it_knows) {
  Publication topic;
  const void* first = topic.publish_bytes();
  EXPECT_EQ(topic.publish(true), 0u);
  const void* second = topic.queue.back();
  topic.numbers.follow({first, second});
  EXPECT_EQ(topic.numbers.queued(), 2u);
  EXPECT_EQ(topic.work_off(), 0u);
  EXPECT_EQ(topic.work_off(), 1u);
  EXPECT_EQ(topic.publish(false), 2u);
  EXPECT_EQ(topic.count, 3u);
}

TEST(SequenceNumbers, bytes_that_it_does_not_follow_change_nothing) {
  Publication topic;
  topic.publish_bytes();
  EXPECT_EQ(topic.work_off(), 0u);
  EXPECT_EQ(topic.publish(false), 1u);
}

TEST(SequenceNumbers, forgetting_skips_what_went_out) {
  Publication topic;
  topic.publish(true);
  topic.publish(false);
  topic.publish(false);
  EXPECT_EQ(topic.numbers.forget(), 2u);
  EXPECT_EQ(topic.numbers.forget(), 0u);
}

TEST(SequenceNumbers, wrap_around) {
  Publication topic;
  topic.count = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(topic.publish(true), std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ(topic.publish(false), 0u);
}

/// In whatever order messages are published and worked off, their numbers are those of one counter.
TEST(SequenceNumbers, any_order_gives_one_sequence) {
  std::mt19937 random(1);
  for (int run = 0; run < 200; ++run) {
    Publication topic;
    std::deque<std::uint32_t> expected;
    std::uint32_t published = 0;
    for (int step = 0; step < 100; ++step) {
      const unsigned choice = random() % 3;
      if (choice == 2 && !topic.queue.empty()) {
        ASSERT_EQ(topic.work_off(), expected.front());
        expected.pop_front();
        continue;
      }
      const bool has_bytes = choice == 0;
      if (has_bytes) expected.push_back(published);
      ASSERT_EQ(topic.publish(has_bytes), published++);
    }
  }
}

}  // namespace
}  // namespace detail
}  // namespace tzc
