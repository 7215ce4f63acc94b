// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <mutex>

namespace tzc::compare {

/// Counts messages, and keeps the times of the input. Thread-safe.
class MessageLog {
 public:
  void count_message() {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++messages_;
  }
  /// @param stamp of the header in nanoseconds, 0: it has none; @param received wall clock in nanoseconds
  void add_input(std::int64_t stamp, std::int64_t received) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++input_messages_;
    if (stamp != 0) inputs_.emplace(stamp, received);
  }

  std::size_t messages() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return messages_;
  }
  std::size_t input_messages() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return input_messages_;
  }
  /// Stamp -> when the first message with it was received.
  std::map<std::int64_t, std::int64_t> inputs() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return inputs_;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::int64_t, std::int64_t> inputs_;
  std::size_t messages_ = 0, input_messages_ = 0;
};

}  // namespace tzc::compare
