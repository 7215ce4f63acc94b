// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <vector>

#include "segment/block.h"
#include "segment/handle_count.h"
#include "segment/spare_nodes.h"

namespace tzc {
namespace segment {

/// The slots of one segment, and which of them are blocks now, by address. The allocator alone takes and returns
/// slots, adds and removes blocks; find and revive may run meanwhile, on any thread.
class LiveBlocks {
 public:
  LiveBlocks(Segment& owner, std::uint32_t most_slots) : owner_(owner), most_slots_(most_slots) {}

  /// Null: all are in use.
  Block* take_slot();
  void return_slot(Block& block) { spare_slots_.push_back(&block); }
  /// Null: the slot was never taken. Any slot number may be asked for.
  Block* at(std::uint32_t slot) { return slot < slots_.size() ? &slots_[slot] : nullptr; }

  /// From now on the block can be found.
  void add(Block& block);
  /// The block is found no more, unless it has handles or `held` says that a subscriber holds it (handle_count.h).
  template <class Held>
  bool remove_if_unused(Block& block, Held held) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (is_in_use(block.handles(), held)) return false;
    nodes_.remove(live_, live_.find(block.offset));
    return true;
  }

  /// The block that contains the bytes, with a handle more. Null: there is none, or it has no handle.
  Block* find(std::uint64_t position, std::size_t bytes) const;
  /// The block of that name with its payload there, with a handle more, its first one perhaps: `first` says so.
  Block* revive(std::uint64_t data_offset, const BlockName& name, bool& first) const;

 private:
  Segment& owner_;
  const std::uint32_t most_slots_;
  std::deque<Block> slots_;  // a deque: blocks never move
  std::vector<Block*> spare_slots_;

  mutable std::mutex mutex_;
  std::map<std::uint64_t, Block*> live_;  // by offset
  SpareNodes<std::map<std::uint64_t, Block*>> nodes_;
};

}  // namespace segment
}  // namespace tzc
