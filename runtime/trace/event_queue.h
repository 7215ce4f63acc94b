// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "trace/event.h"

namespace tzc {
namespace trace {

/// A bounded queue from any number of threads to one, without a lock: who adds never waits, and is refused when it is
/// full. Each place has a ticket that says whose turn it is (D. Vyukov's bounded queue): a thread that is stopped between
/// its place and its event holds back the reader, and no other writer before the queue is full.
class EventQueue {
 public:
  /// `capacity`: a power of two.
  explicit EventQueue(std::size_t capacity);
  /// False: it is full. Any thread.
  bool push(const Event& event) noexcept;
  /// False: there is none. One thread at a time.
  bool pop(Event& event) noexcept;

 private:
  struct Place {
    std::atomic<std::uint64_t> ticket;
    Event event;
  };

  std::vector<Place> places_;
  const std::uint64_t mask_;
  alignas(64) std::atomic<std::uint64_t> pushed_{0};
  alignas(64) std::uint64_t popped_ = 0;
};

}  // namespace trace
}  // namespace tzc
