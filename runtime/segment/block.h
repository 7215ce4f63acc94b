// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// What the publisher alone knows about one slot of its segment. The slot outlives its blocks: each block
/// that uses it has a generation of its own.
struct Block : Buffer {
  std::uint64_t offset = 0;  // of its header in the segment
  std::uint64_t extent = 0;  // bytes with header and rounding
  Block* older = nullptr;    // links of the queue of blocks in use
  Block* newer = nullptr;
};

/// Names a block in every process: what records carry.
struct BlockName {
  std::uint64_t segment;
  std::uint32_t slot;
  std::uint32_t generation;
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
