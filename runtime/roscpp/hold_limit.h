// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace tzc {
namespace detail {

/// Limits how much of a publisher's memory the views of one subscription, or of all callbacks in the publisher's own process, may
/// hold, so that one that keeps messages cannot take the shared memory from all others: beyond half of the memory, but not below
/// kFewMessages messages, it gets copies. Thread-safe; views may end on any thread, also after this object.
class HoldLimit {
 public:
  /// A subscriber may hold this many messages of any size.
  static constexpr std::size_t kFewMessages = 24;
  /// Half of the default ceiling of a publisher's memory, until the publisher sends its own limit
  /// (set_most_bytes).
  static constexpr std::uint64_t kDefaultBytes = std::uint64_t{1} << 29;

  void set_most_bytes(std::uint64_t bytes) { most_bytes_ = bytes; }
  std::uint64_t most_bytes() const { return most_bytes_; }
  std::uint64_t held_bytes() const { return held_->bytes; }
  std::size_t held_messages() const { return held_->messages; }

  /// Whether one more message may be held, of so many bytes in the publisher's memory.
  bool allows(std::uint64_t bytes) const {
    return held_->messages < kFewMessages || held_->bytes + bytes <= most_bytes_;
  }
  /// Counts a message, and keeps `kept`, until the last copy of the returned pointer is destroyed.
  std::shared_ptr<const void> hold(std::uint64_t bytes, std::shared_ptr<const void> kept) const;

 private:
  struct Held {
    std::atomic<std::uint64_t> bytes{0};
    std::atomic<std::size_t> messages{0};
  };

  std::atomic<std::uint64_t> most_bytes_{kDefaultBytes};
  const std::shared_ptr<Held> held_ = std::make_shared<Held>();
};

}  // namespace detail
}  // namespace tzc
