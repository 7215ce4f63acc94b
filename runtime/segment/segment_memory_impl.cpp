// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment_memory_impl.h"

#include <algorithm>

#include "posix/fork_epoch.h"
#include "posix/mapping.h"
#include "segment/size_class.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace segment {
namespace {

constexpr std::size_t visits_per_allocate = 16;

// In guard mode blocks take whole pages, and some are kept from reuse; that must not look like a memory that is too small.
std::size_t guarded_size(std::size_t size) {
  constexpr std::size_t enough = std::size_t{64} << 20;
  return guard::active && size < SIZE_MAX / 8 ? 4 * size + enough : size;
}

std::size_t guarded_bytes(std::size_t bytes) {
  return guard::active ? std::max(bytes, posix::page_size()) : bytes;
}

/// Handles beside those of records that wait in queues: the program's own message refers to the block, so it cannot be reclaimed
/// whatever is revoked.
bool has_other_handles(Block& block) {
  const std::size_t waiting = Segment::of(block).holders().waiting_handles(Segment::name_of(block));
  return block.handles().load(std::memory_order_acquire) > waiting;
}

/// Reuses what guard mode keeps from reuse, until there is room.
Block* allocate_in_quarantine(const SegmentList& segments, std::size_t bytes, Error& failure) {
  for (const SegmentList::Entry& segment : segments) {
    while (segment->guard() != nullptr && segment->guard()->cut_quarantine()) {
      if (Block* block = segment->allocate_block(bytes, Segment::Where::anywhere, failure)) return block;
    }
  }
  return nullptr;
}

/// The largest block that there would be room for if nothing were in use. Segments that are too small make way for one that
/// is not, but only where no size was given.
std::size_t most_bytes(const SegmentList& segments, const MemoryOptions& options) {
  std::size_t most = options.size == 0 ? options.ceiling : 0;
  for (const SegmentList::Entry& segment : segments) most = std::max(most, segment->file().payload_bytes());
  return most;
}

/// Of an allocate of so many bytes in a memory that has room for `most`. The system's reason comes first: where it refused
/// pages, there would have been room.
AllocationError why_refused(std::size_t bytes, const Error& system, std::size_t most) {
  using Cause = AllocationError::Cause;
  AllocationError why;
  static_cast<Error&>(why) = system;
  why.cause = system.code != 0 ? Cause::system : bytes > most ? Cause::too_large : Cause::in_use;
  if (why.cause == Cause::too_large)
    why.hint = "larger than the whole memory, which has room for " + std::to_string(most) +
               " bytes: give the publisher more memory";
  if (why.cause == Cause::in_use)
    why.hint = "subscribers still use the older messages: give the publisher more memory";
  return why;
}

}  // namespace

SegmentMemoryImpl::SegmentMemoryImpl(const MemoryOptions& options)
    : options_(options), epoch_(posix::fork_epoch()), segments_(options_) {}

Status SegmentMemoryImpl::open() {
  return options_.size == 0 ? Status(Success{}) : segments_.add(guarded_size(options_.size));
}

BufferPtr SegmentMemoryImpl::allocate(std::size_t bytes) {
  if (posix::forked_since(epoch_))
    return nullptr;  // the parent's allocator owns this memory; don't even lock
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure_.code != 0) failure_ = Error();
  if (bytes > SIZE_MAX / 4) return refuse(bytes, bytes);
  sync_point("allocate: begin");
  const std::size_t occupied = occupied_bytes(guarded_bytes(bytes), posix::page_size());
  Block* block = find_room(occupied);
  return block != nullptr ? admit(*block) : refuse(bytes, occupied);
}

Block* SegmentMemoryImpl::find_room(std::size_t bytes) {
  reclaim(visits_per_allocate, SIZE_MAX);
  if (Block* block = allocate_block(bytes, Segment::Where::touched_memory)) return block;
  const bool bounded = options_.policy.kind == PolicyKind::medium_effort;
  reclaim(SIZE_MAX, bounded ? options_.policy.attempts : SIZE_MAX);
  sync_point("allocate: reclaimed");
  if (Block* block = allocate_block(bytes, Segment::Where::touched_memory)) return block;
  if (Block* block = allocate_block(bytes, Segment::Where::anywhere)) return block;
  if (Block* block = grow_and_allocate(bytes)) return block;
  if (guard::active) {
    if (Block* block = allocate_in_quarantine(segments_, bytes, failure_)) return block;
  }
  for (const SegmentList::Entry& segment : segments_) segment->holders().revoke_buffered();
  reclaim(SIZE_MAX, SIZE_MAX);
  if (Block* block = allocate_block(bytes, Segment::Where::anywhere)) return block;
  return options_.policy.kind == PolicyKind::best_effort ? revoke_and_allocate(bytes) : nullptr;
}

Block* SegmentMemoryImpl::allocate_block(std::size_t bytes, Segment::Where where) {
  return segments_.allocate_block(bytes, where, failure_);
}

void SegmentMemoryImpl::reclaim(std::size_t visits, std::size_t passes) {
  if (options_.policy.kind == PolicyKind::worst_effort) return reclaim_in_order(visits);
  for (const SegmentList::Entry& segment : segments_) {
    // A peer can hint at slots as fast as they are looked at; each holder has its turn before this ends.
    const std::size_t most = std::min(visits, segment->file().slots() * (segment->holders().count() + 1));
    for (std::size_t i = 0; i < most; ++i) {
      Block* block = segment->next_released();
      if (block == nullptr) break;
      if (try_reclaim(*block)) continue;
      bring_back(*block);
      if (passes-- == 0) return;
    }
  }
}

// Blocks that are still being filled are no messages yet: the policy does not count them.
void SegmentMemoryImpl::reclaim_in_order(std::size_t visits) {
  for (Block* next = queue_.oldest(); next != nullptr && visits > 0; --visits) {
    Block& block = *next;
    next = block.newer;
    const bool sealed = block.sealed();
    if (!try_reclaim(block) && sealed) return;
  }
}

bool SegmentMemoryImpl::try_reclaim(Block& block) {
  const std::size_t size = block.size();
  if (!Segment::of(block).free_if_unused(block)) return false;
  (block.put_aside ? aside_ : queue_).remove(block);
  stats_.used_bytes -= size;
  --stats_.used_blocks;
  ++stats_.reclaimed;
  return true;
}

// What is wanted (room for the queue, twice what there is, the ceiling) are wishes: where the system has not got so much, room for
// this message will do.
Block* SegmentMemoryImpl::grow_and_allocate(std::size_t bytes) {
  if (options_.size != 0) return nullptr;
  const bool first = segments_.count() == 0;
  segments_.drop_unused();
  const std::size_t total = segments_.total_size();
  const std::size_t room = options_.ceiling > total ? options_.ceiling - total : 0;
  const std::size_t wanted = std::max(total, first_size(bytes, options_));
  const std::size_t most = first ? wanted : std::min(wanted, room);
  if (most < bytes) return nullptr;
  const Status added = segments_.add_up_to(most, bytes);
  failure_ = added ? Error() : added.error();
  return added ? allocate_block(bytes, Segment::Where::anywhere) : nullptr;
}

// First what is in flight to subscribers, then what still waits in this process's queues.
Block* SegmentMemoryImpl::revoke_and_allocate(std::size_t bytes) {
  if (Block* block = revoke_blocks(bytes, false)) return block;
  return revoke_blocks(bytes, true);
}

Block* SegmentMemoryImpl::revoke_blocks(std::size_t bytes, bool with_handles) {
  for (Block* next = queue_.oldest(); next != nullptr;) {
    Block& block = *next;
    next = block.newer;
    Segment& segment = Segment::of(block);
    const BlockName name = Segment::name_of(block);
    if (!block.sealed() || block.has_handles() != with_handles) continue;
    if (segment.holders().have_taken(name)) {
      put_aside(block);
      continue;
    }
    if (with_handles && has_other_handles(block)) continue;
    sync_point("allocate: revoking");
    segment.holders().revoke(name);
    if (!try_reclaim(block)) continue;
    ++stats_.revoked;
    if (Block* room = allocate_block(bytes, Segment::Where::anywhere)) return room;
  }
  return nullptr;
}

void SegmentMemoryImpl::put_aside(Block& block) {
  queue_.remove(block);
  aside_.push(block);
  block.put_aside = true;
}

void SegmentMemoryImpl::bring_back(Block& block) {
  if (!block.put_aside) return;
  aside_.remove(block);
  queue_.push_oldest(block);
  block.put_aside = false;
}

BufferPtr SegmentMemoryImpl::admit(Block& block) {
  queue_.push(block);
  stats_.used_bytes += block.size();
  ++stats_.used_blocks;
  ++stats_.allocated;
  segments_.note_allocated(block.size(), stats_.used_bytes);
  return block.handle();
}

BufferPtr SegmentMemoryImpl::refuse(std::size_t bytes, std::size_t occupied) {
  ++stats_.refused;
  last_ = why_refused(occupied, failure_, most_bytes(segments_, options_));
  last_.what = "allocate " + std::to_string(bytes) + " bytes" + (last_.what.empty() ? "" : ": " + last_.what);
  last_.where = options_.name;
  failure_ = Error();
  return nullptr;
}

// Another thread of the parent may have held the lock.
MemoryStats SegmentMemoryImpl::stats() const {
  if (posix::forked_since(epoch_)) return MemoryStats();
  const std::lock_guard<std::mutex> lock(mutex_);
  MemoryStats stats = stats_;
  stats.segments = segments_.count();
  stats.size_bytes = segments_.total_size();
  for (const SegmentList::Entry& segment : segments_)
    stats.reserved_bytes += segment->file().committed_bytes();
  return stats;
}

AllocationError SegmentMemoryImpl::last_failure() const {
  if (posix::forked_since(epoch_)) return AllocationError();
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

}  // namespace segment
}  // namespace tzc
