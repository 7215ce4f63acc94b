// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <vector>

namespace tzc {
namespace detail {

/// Counts header.seq as TCPROS does. roscpp numbers a message when it sends its publish queue, but a shared
/// message needs its number when it is published. So this class counts the queued messages ahead, and tells
/// by how much roscpp must advance its own count for messages that were sent with a number.
///
///   roscpp's count  5      queue  [a b]      take(nothing queued) -> 7, and roscpp skips one after b
///
/// Knows nothing of roscpp; the caller applies what is returned. Not thread-safe.
class SequenceNumbers {
 public:
  struct Taken {
    std::uint32_t number;
    bool counts_now;  ///< roscpp's count has to be incremented at once
  };

  /// Returns the number of a message that is published now.
  /// @param queued its bytes, which also go into roscpp's queue; null: it is published by pointer alone
  /// @param count roscpp's own count
  Taken take(const void* queued, std::uint32_t count);

  /// Returns the number that take() would return.
  std::uint32_t next(std::uint32_t count) const {
    return static_cast<std::uint32_t>(count + waiting_.size());
  }

  /// Returns the number of known messages in roscpp's queue.
  std::size_t queued() const;

  /// roscpp has taken these bytes from its queue and numbered them. Older ones, if there are any, never came into it: something threw while
  /// they were published.
  /// @return by how much roscpp must advance its count
  std::size_t numbered(const void* bytes);

  /// Adds the messages in roscpp's queue, as bytes, that wait for a number, in their order. Those that are known are not
  /// counted twice. Without memory nothing changes.
  void follow(const std::vector<const void*>& queue);

  /// Ends the counting. @return by how much roscpp must advance its count
  std::size_t forget();

 private:
  std::size_t skip_numbered();

  /// Messages in roscpp's queue, as bytes, oldest first, and between them a null for each message that was
  /// sent with a number.
  std::list<const void*> waiting_;  // one that is empty, as usual, has no memory; a deque has half a kilobyte
};

}  // namespace detail
}  // namespace tzc
