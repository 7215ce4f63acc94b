// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// Names a block in every process: what records carry.
struct BlockName {
  std::uint64_t segment;
  std::uint32_t slot;
  std::uint32_t generation;
};
inline bool operator==(const BlockName& a, const BlockName& b) noexcept {
  return a.segment == b.segment && a.slot == b.slot && a.generation == b.generation;
}

/// What the publisher alone knows about one slot of its segment. The slot outlives its blocks: each block that uses
/// it has a generation of its own.
struct Block : Buffer {
  Block(Segment& owner, std::uint32_t slot, std::uint32_t first_generation) {
    segment_ = &owner;
    slot_ = slot;
    generation_ = first_generation;
  }

  std::uint32_t slot() const { return slot_; }
  std::uint32_t generation() const { return generation_; }
  bool has_handles() const { return references_.load(std::memory_order_acquire) != 0; }
  /// The count of handles, for handle_count.h.
  std::atomic<std::uint32_t>& handles() { return references_; }
  /// One that was counted already.
  BufferPtr handle() { return BufferPtr(this, BufferPtr::Adopt{}); }
  /// A new block with one handle lives in the slot.
  void open(std::uint32_t new_generation, std::uint8_t* data, std::size_t size) {
    generation_ = new_generation;
    data_ = data;
    size_ = size;
    put_aside = false;
    sealed_.store(false, std::memory_order_relaxed);
    references_.store(1, std::memory_order_release);
  }

  std::uint64_t offset = 0;  // of its payload in the segment
  std::uint64_t extent = 0;  // bytes with rounding; 0: no block lives in the slot
  bool put_aside = false;  // a subscriber took it: revoking others does not help until something is released
  Block* older = nullptr;  // links of the queue of blocks in use
  Block* newer = nullptr;
};

/// The blocks in use, oldest first. Intrusive: a block is in at most one queue, nothing is allocated.
class BlockQueue {
 public:
  Block* oldest() const { return oldest_; }

  void push(Block& block) {
    block.older = newest_;
    block.newer = nullptr;
    (newest_ ? newest_->newer : oldest_) = &block;
    newest_ = &block;
  }

  void push_oldest(Block& block) {
    block.older = nullptr;
    block.newer = oldest_;
    (oldest_ ? oldest_->older : newest_) = &block;
    oldest_ = &block;
  }

  void remove(Block& block) {
    (block.older ? block.older->newer : oldest_) = block.newer;
    (block.newer ? block.newer->older : newest_) = block.older;
    block.older = block.newer = nullptr;
  }

 private:
  Block* oldest_ = nullptr;
  Block* newest_ = nullptr;
};

}  // namespace segment
}  // namespace tzc
