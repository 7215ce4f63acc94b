// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace tzc_test {

/// Events that threads wait for, so that a race takes the turn that a test wants. Thread-safe.
class Gate {
 public:
  void tell(const std::string& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    happened_.insert(event);
    changed_.notify_all();
  }
  bool happened(const std::string& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return happened_.count(event) != 0;
  }
  /// False: none of them happened in time.
  bool wait_for(const std::set<std::string>& events,
                std::chrono::milliseconds time = std::chrono::seconds(120)) {
    std::unique_lock<std::mutex> lock(mutex_);
    return changed_.wait_for(lock, time, [&] {
      for (const std::string& event : events)
        if (happened_.count(event) != 0) return true;
      return false;
    });
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::set<std::string> happened_;
};

}  // namespace tzc_test
