// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/console.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <mutex>
#include <string>

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

/// A Throttle for each of several subjects (topics, connections), so that none of them silences another. Thread-safe.
class ThrottleBySubject {
 public:
  using Clock = std::chrono::steady_clock;
  /// What comes within one period beyond so many subjects shares one throttle.
  static constexpr std::size_t kMostSubjects = 256;

  explicit ThrottleBySubject(std::chrono::seconds period) : period_(period) {}

  bool is_due(const std::string& subject, Clock::time_point now = Clock::now()) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto known = next_.find(subject);
    if (known != next_.end()) return is_due(known->second, now);
    if (next_.size() >= kMostSubjects) forget_those_due(now);
    return is_due(next_.size() < kMostSubjects ? next_[subject] : next_of_others_, now);
  }

 private:
  bool is_due(Clock::time_point& next, Clock::time_point now) const {
    if (now < next) return false;
    next = now + period_;
    return true;
  }
  void forget_those_due(Clock::time_point now) {
    for (auto it = next_.begin(); it != next_.end();)
      it = it->second <= now ? next_.erase(it) : std::next(it);
  }

  const std::chrono::seconds period_;
  std::mutex mutex_;
  std::map<std::string, Clock::time_point> next_;
  Clock::time_point next_of_others_;
};

/// What a failure with this errno concerns: a process without descriptors has none for any of its topics, so one warning speaks
/// for all of them.
inline std::string subject_of(int code, const std::string& subject) {
  return code == EMFILE || code == ENFILE ? "every topic" : subject;
}

}  // namespace detail
}  // namespace tzc

/// Warns at most once in so many seconds from this place in the code: of what concerns the whole process.
#define TZC_WARN_THROTTLED(period, text)                                                 \
  do {                                                                                   \
    static ::tzc::detail::Throttle throttle_of_this_place{std::chrono::seconds(period)}; \
    if (throttle_of_this_place.is_due()) ROS_WARN_STREAM(text);                          \
  } while (false)

/// Warns at most once in so many seconds from this place in the code and of this subject: a topic, or what else is to be
/// told apart. The throttle is made with the first warning, and outlives every thread that could warn.
#define TZC_WARN_THROTTLED_FOR(subject, period, text)                        \
  do {                                                                       \
    static auto& throttle_of_this_place =                                    \
        *new ::tzc::detail::ThrottleBySubject{std::chrono::seconds(period)}; \
    if (throttle_of_this_place.is_due(subject)) ROS_WARN_STREAM(text);       \
  } while (false)
