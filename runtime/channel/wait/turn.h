// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>

namespace tzc {
namespace channel {

/// Whose turn it is to read: the reader's, or that of a guest (receiver.h). A guest that waits comes first, and the reader can
/// see that it does: one with much to do would take a mutex again before the guest is awake. Thread-safe.
class Turn {
 public:
  void take_as_reader() { take(false); }
  /// One thread at a time.
  void take_as_guest() {
    is_wanted_ = true;
    take(true);
  }
  void give() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_taken_ = false;
    }
    given_.notify_all();
  }
  /// Whether a guest waits for it.
  bool is_wanted() const { return is_wanted_.load(std::memory_order_relaxed); }

 private:
  void take(bool is_guest) {
    std::unique_lock<std::mutex> lock(mutex_);
    given_.wait(lock, [&] { return !is_taken_ && (is_guest || !is_wanted_); });
    is_taken_ = true;
    if (is_guest) is_wanted_ = false;
  }

  std::mutex mutex_;
  std::condition_variable given_;
  bool is_taken_ = false;
  std::atomic<bool> is_wanted_{false};
};

}  // namespace channel
}  // namespace tzc
