// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>

#include "segment/block.h"
#include "segment/segment.h"
#include "segment/segment_list.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// The allocator of one publisher: its segments, the queue of blocks in use, and what happens when there is
/// no room.
///
///   allocate:  reclaim a few -> fit into touched memory -> reclaim all -> fit anywhere -> add a segment
///              -> revoke what is beyond the queues -> revoke what is in them
///
/// To reclaim looks at the blocks of which something was released (release_hints.h); only worst_effort, which wants
/// the oldest one first, walks the queue.
///
/// Touched memory comes first because a fresh page costs a fault. Thread-safe through one lock of this
/// process.
class SegmentMemoryImpl {
 public:
  explicit SegmentMemoryImpl(const MemoryOptions& options);

  Status open();  ///< creates the first segment when the total size is given
  BufferPtr allocate(std::size_t bytes);
  MemoryStats stats() const;
  AllocationError last_failure() const;
  const MemoryOptions& options() const { return options_; }

 private:
  Block* find_room(std::size_t bytes);
  Block* allocate_block(std::size_t bytes, Segment::Where where);
  Block* grow_and_allocate(std::size_t bytes);
  Block* revoke_and_allocate(std::size_t bytes);
  Block* revoke_blocks(std::size_t bytes, bool with_handles);
  void reclaim(std::size_t visits, std::size_t passes);
  void reclaim_in_order(std::size_t visits);
  bool try_reclaim(Block& block);
  void put_aside(Block& block);
  void bring_back(Block& block);
  BufferPtr admit(Block& block);
  BufferPtr refuse(std::size_t bytes, std::size_t occupied);

  const MemoryOptions options_;
  const std::uint32_t epoch_;
  mutable std::mutex mutex_;
  SegmentList segments_;
  BlockQueue queue_;  // of blocks in use
  BlockQueue
      aside_;  // of those that a subscriber took: nothing can be revoked there until something is released
  MemoryStats stats_;
  Error failure_;         // of the system, during the allocate that runs
  AllocationError last_;  // of the latest allocate that was refused
};

}  // namespace segment
}  // namespace tzc
