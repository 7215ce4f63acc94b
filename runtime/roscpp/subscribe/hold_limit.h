// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/channel.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace tzc {
namespace detail {

/// Limits how much of a publisher's memory the views of one subscription may hold, so that a subscriber that
/// keeps its messages cannot take the shared memory from all others: beyond half of the memory, but not below
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

  bool allows(const channel::Message& message) const {
    return held_->messages < kFewMessages || held_->bytes + size_of(message) <= most_bytes_;
  }
  /// Keeps the message, and counts it until the last copy of the returned pointer is destroyed.
  std::shared_ptr<const void> hold(const channel::MessagePtr& message) const;

 private:
  struct Held {
    std::atomic<std::uint64_t> bytes{0};
    std::atomic<std::size_t> messages{0};
  };
  static std::uint64_t size_of(const channel::Message& message);

  std::atomic<std::uint64_t> most_bytes_{kDefaultBytes};
  const std::shared_ptr<Held> held_ = std::make_shared<Held>();
};

}  // namespace detail
}  // namespace tzc
