// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <time.h>

#include <atomic>

namespace tzc {
namespace detail {

/// A mutex of one byte for what is short and seldom contended. Who waits sleeps, so that a thread of a high priority lets the
/// holder run. BasicLockable, for std::lock_guard.
class SleepLock {
 public:
  void lock() noexcept {
    while (is_held_.exchange(true, std::memory_order_acquire)) {
      const timespec twenty_microseconds{0, 20000};
      ::nanosleep(&twenty_microseconds, nullptr);
    }
  }
  void unlock() noexcept { is_held_.store(false, std::memory_order_release); }

 private:
  std::atomic<bool> is_held_{false};
};

}  // namespace detail
}  // namespace tzc
