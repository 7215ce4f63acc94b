// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/console.h>

#include <atomic>
#include <chrono>
#include <cstdint>

namespace tzc {
namespace detail {

/// True at most once in each period of the steady clock. roscpp's own throttled macros use ros::Time, which
/// throws before it is initialised and stops in a paused simulation. Thread-safe.
class Throttle {
 public:
  explicit constexpr Throttle(std::chrono::seconds period) : period_(period) {}

  bool is_due() {
    const std::int64_t now = std::chrono::steady_clock::now().time_since_epoch().count();
    std::int64_t next = next_.load();
    return now >= next && next_.compare_exchange_strong(next, now + Ticks(period_).count());
  }

 private:
  using Ticks = std::chrono::steady_clock::duration;

  const std::chrono::seconds period_;
  std::atomic<std::int64_t> next_{0};
};

}  // namespace detail
}  // namespace tzc

/// Warns at most once in so many seconds from this place in the code.
#define TZC_WARN_THROTTLED(period, text)                                                 \
  do {                                                                                   \
    static ::tzc::detail::Throttle throttle_of_this_place{std::chrono::seconds(period)}; \
    if (throttle_of_this_place.is_due()) ROS_WARN_STREAM(text);                          \
  } while (false)
