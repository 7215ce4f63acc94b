// SPDX-License-Identifier: BSD-3-Clause
#include "trace/event_queue.h"

namespace tzc {
namespace trace {

EventQueue::EventQueue(std::size_t capacity) : places_(capacity), mask_(capacity - 1) {
  for (std::size_t i = 0; i < capacity; ++i) places_[i].ticket.store(i, std::memory_order_relaxed);
}

bool EventQueue::push(const Event& event) noexcept {
  std::uint64_t turn = pushed_.load(std::memory_order_relaxed);
  for (;;) {
    Place& place = places_[turn & mask_];
    const std::uint64_t ticket = place.ticket.load(std::memory_order_acquire);
    if (ticket == turn) {
      if (!pushed_.compare_exchange_weak(turn, turn + 1, std::memory_order_relaxed)) continue;
      place.event = event;
      place.ticket.store(turn + 1, std::memory_order_release);
      return true;
    }
    if (static_cast<std::int64_t>(ticket - turn) < 0) return false;
    turn = pushed_.load(std::memory_order_relaxed);
  }
}

bool EventQueue::pop(Event& event) noexcept {
  Place& place = places_[popped_ & mask_];
  if (place.ticket.load(std::memory_order_acquire) != popped_ + 1) return false;
  event = place.event;
  place.ticket.store(popped_ + mask_ + 1, std::memory_order_release);
  ++popped_;
  return true;
}

}  // namespace trace
}  // namespace tzc
