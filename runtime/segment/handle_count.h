// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

// The count of a block's handles in its own process, and when the block may be freed.
//
// A new handle comes from an existing one, from an address (find), or from a record that is in flight (revive: the
// subscriber left, its records go another way, then its marks are revoked). A block is free when it has no handle and
// no subscriber holds it. To look at both takes several loads, and meanwhile a handle may be made, a mark set or
// revoked: so find, revive and the look at one block exclude each other through one lock. Under it a block without
// handles gets none, without handles no mark is set, and marks can only go: what was seen last is true of all.
//
// Templated on the atomic type so that the model checker runs this very code (tests/model/handle_model.cpp).

namespace tzc {
namespace segment {

/// find: a handle more, unless there is none, because the block may be free.
template <class Atomic>
bool add_handle_if_any(Atomic& handles) {
  auto count = handles.load(std::memory_order_relaxed);
  while (count != 0) {
    if (handles.compare_exchange_weak(count, count + 1, std::memory_order_acquire, std::memory_order_relaxed))
      return true;
  }
  return false;
}

/// revive: a handle more; true: it is the first one. A mark in flight keeps the block.
template <class Atomic>
bool add_handle(Atomic& handles) {
  return handles.fetch_add(1, std::memory_order_acq_rel) == 0;
}

/// `held`: whether any subscriber holds the block. Only under the lock that find and revive take.
template <class Atomic, class Held>
bool is_in_use(const Atomic& handles, Held held) {
  return handles.load(std::memory_order_acquire) != 0 || held();
}

}  // namespace segment
}  // namespace tzc
