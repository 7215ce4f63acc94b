// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pthread.h>
#include <time.h>

#include <chrono>
#include <mutex>

namespace tzc {
namespace detail {

/// std::condition_variable whose waits end on time whatever happens to the system's clock. Before GCC 10 the standard library's wait by that
/// clock also where it is given a steady one: a clock that is set back by an hour, as after a robot's start, made them an hour longer.
/// Spurious wake-ups are possible. Thread-safe.
class MonotonicCondition {
 public:
  using Clock = std::chrono::steady_clock;  // CLOCK_MONOTONIC

  MonotonicCondition() {
    pthread_condattr_t attributes;
    ::pthread_condattr_init(&attributes);
    ::pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
    ::pthread_cond_init(&condition_, &attributes);
    ::pthread_condattr_destroy(&attributes);
  }
  ~MonotonicCondition() { ::pthread_cond_destroy(&condition_); }
  MonotonicCondition(const MonotonicCondition&) = delete;
  MonotonicCondition& operator=(const MonotonicCondition&) = delete;

  void notify_one() { ::pthread_cond_signal(&condition_); }
  void notify_all() { ::pthread_cond_broadcast(&condition_); }

  void wait(std::unique_lock<std::mutex>& lock) {
    ::pthread_cond_wait(&condition_, lock.mutex()->native_handle());
  }
  template <class Holds>
  void wait(std::unique_lock<std::mutex>& lock, Holds holds) {
    while (!holds()) wait(lock);
  }
  void wait_until(std::unique_lock<std::mutex>& lock, Clock::time_point time) {
    const auto since = std::chrono::duration_cast<std::chrono::nanoseconds>(time.time_since_epoch());
    const timespec end{static_cast<time_t>(since.count() / 1'000'000'000),
                       static_cast<long>(since.count() % 1'000'000'000)};
    ::pthread_cond_timedwait(&condition_, lock.mutex()->native_handle(), &end);
  }
  void wait_for(std::unique_lock<std::mutex>& lock, Clock::duration most) {
    wait_until(lock, Clock::now() + most);
  }

 private:
  pthread_cond_t condition_;
};

}  // namespace detail
}  // namespace tzc
