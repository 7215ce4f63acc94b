// SPDX-License-Identifier: BSD-3-Clause
#include "trace/event_queue.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace tzc {
namespace trace {
namespace {

Event numbered(std::uint32_t thread, std::uint64_t number) {
  return Event{number, ~number, 0, 0, "", thread, Step::publish, Arrow::none};
}

TEST(EventQueue, gives_events_in_order_and_refuses_when_it_is_full) {
  EventQueue queue(4);
  Event event{};
  EXPECT_FALSE(queue.pop(event));
  for (int round = 0; round < 3; ++round) {
    for (std::uint64_t i = 0; i < 4; ++i) EXPECT_TRUE(queue.push(numbered(1, i)));
    EXPECT_FALSE(queue.push(numbered(1, 99)));
    for (std::uint64_t i = 0; i < 4; ++i) {
      ASSERT_TRUE(queue.pop(event));
      EXPECT_EQ(event.begin_ns, i);
    }
    EXPECT_FALSE(queue.pop(event));
  }
}

TEST(EventQueue, of_many_threads_loses_and_tears_nothing) {
  constexpr std::uint64_t each = 20000;
  constexpr std::uint32_t threads = 4;
  EventQueue queue(64);
  std::vector<std::thread> writers;
  for (std::uint32_t thread = 0; thread < threads; ++thread)
    writers.emplace_back([&queue, thread] {
      for (std::uint64_t i = 0; i < each;)
        if (queue.push(numbered(thread, i)))
          ++i;
        else
          std::this_thread::yield();
    });
  std::vector<std::uint64_t> next(threads, 0);
  Event event{};
  for (std::uint64_t seen = 0; seen < each * threads;) {
    if (!queue.pop(event)) {
      std::this_thread::yield();
      continue;
    }
    ++seen;
    ASSERT_EQ(event.begin_ns, next.at(event.thread)++);
    ASSERT_EQ(event.end_ns, ~event.begin_ns);
  }
  for (std::thread& writer : writers) writer.join();
  EXPECT_FALSE(queue.pop(event));
}

}  // namespace
}  // namespace trace
}  // namespace tzc
