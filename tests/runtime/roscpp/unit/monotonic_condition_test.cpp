// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/monotonic_condition.h"

#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <thread>

namespace tzc {
namespace detail {
namespace {

using std::chrono::milliseconds;

TEST(MonotonicCondition, waits_until_the_time_at_most) {
  std::mutex mutex;
  MonotonicCondition condition;
  std::unique_lock<std::mutex> lock(mutex);
  const auto end = MonotonicCondition::Clock::now() + milliseconds(30);
  while (MonotonicCondition::Clock::now() < end) condition.wait_until(lock, end);
  EXPECT_TRUE(lock.owns_lock());
  condition.wait_for(lock, milliseconds(-5));  // is over already
}

TEST(MonotonicCondition, wakes_who_waits) {
  std::mutex mutex;
  MonotonicCondition condition;
  bool is_told = false;
  std::thread teller([&] {
    const std::lock_guard<std::mutex> lock(mutex);
    is_told = true;
    condition.notify_all();
  });
  std::unique_lock<std::mutex> lock(mutex);
  condition.wait(lock, [&] { return is_told; });
  EXPECT_TRUE(is_told);
  lock.unlock();
  teller.join();
}

}  // namespace
}  // namespace detail
}  // namespace tzc
