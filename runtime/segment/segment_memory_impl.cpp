// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment_memory_impl.h"

#include <algorithm>

#include "posix/fork_epoch.h"
#include "posix/step.h"
#include "segment/layout.h"
#include "segment/size_class.h"

namespace tzc {
namespace segment {
namespace {

constexpr std::size_t visits_per_allocate = 16;
constexpr std::size_t least_blocks = 4;

// How many blocks in use a walk may pass before it stops: the whole difference between the policies.
std::size_t allowed_passes(const Policy& policy) {
  switch (policy.kind) {
    case PolicyKind::worst_effort:
      return 0;
    case PolicyKind::medium_effort:
      return policy.attempts;
    case PolicyKind::best_effort:
      break;
  }
  return SIZE_MAX;
}

}  // namespace

SegmentMemoryImpl::SegmentMemoryImpl(const MemoryOptions& options)
    : options_(options), epoch_(posix::fork_epoch()) {}

SegmentMemoryImpl::~SegmentMemoryImpl() {
  for (const SegmentPtr& segment : segments_) segment->retire();
}

Status SegmentMemoryImpl::open() {
  if (options_.size == 0 || add_segment(options_.size)) return Success{};
  return failure_;
}

BufferPtr SegmentMemoryImpl::allocate(std::size_t bytes) {
  if (posix::forked_since(epoch_))
    return nullptr;  // the parent's allocator owns this memory; don't even lock
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure_.code != 0) failure_ = Error();
  if (bytes > SIZE_MAX / 4) return refuse(bytes);
  posix::step("allocate: begin");
  Block* block = find_room(size_class(bytes));
  return block != nullptr ? hand_out(*block) : refuse(bytes);
}

Block* SegmentMemoryImpl::find_room(std::size_t bytes) {
  reclaim(visits_per_allocate);
  if (Block* block = carve(bytes, Segment::Where::touched_memory)) return block;
  reclaim_everything();
  posix::step("allocate: reclaimed");
  if (Block* block = carve(bytes, Segment::Where::touched_memory)) return block;
  if (Block* block = carve(bytes, Segment::Where::anywhere)) return block;
  if (Block* block = grow_and_carve(bytes)) return block;
  return options_.policy.kind == PolicyKind::best_effort ? revoke_and_carve(bytes) : nullptr;
}

Block* SegmentMemoryImpl::carve(std::size_t bytes, Segment::Where where) {
  for (const SegmentPtr& segment : segments_) {
    if (Block* block = segment->carve(bytes, where, failure_)) return block;
  }
  return nullptr;
}

// Blocks that are still being filled are no messages yet: no policy counts them.
void SegmentMemoryImpl::reclaim(std::size_t visits) {
  std::size_t passes_left = allowed_passes(options_.policy);
  Block* next = queue_.oldest();
  for (; next != nullptr && visits > 0; --visits) {
    Block& block = *next;
    next = block.newer;
    if (!Segment::of(block).in_use(block)) {
      take_back(block);
    } else if (block.sealed() && passes_left-- == 0) {
      return;
    }
  }
}

// Asks before the walk: what is released meanwhile counts for the next one.
void SegmentMemoryImpl::reclaim_everything() {
  bool anything = false;
  for (const SegmentPtr& segment : segments_) anything |= segment->notice_releases();
  if (anything) reclaim(SIZE_MAX);
}

void SegmentMemoryImpl::take_back(Block& block) {
  queue_.remove(block);
  Segment::of(block).give_back(block);
  stats_.used_bytes -= block.size();
  --stats_.used_blocks;
  ++stats_.reclaimed;
}

Block* SegmentMemoryImpl::grow_and_carve(std::size_t bytes) {
  if (options_.size != 0) return nullptr;
  if (segments_.empty())
    return add_segment(first_size(bytes)) ? carve(bytes, Segment::Where::anywhere) : nullptr;
  drop_unused_segments();
  const std::size_t total = total_size();
  const std::size_t room = options_.ceiling > total ? options_.ceiling - total : 0;
  const std::size_t needed = segment_header_bytes + block_header_bytes + bytes;
  const std::size_t wanted = std::min(std::max(total, first_size(bytes)), room);
  if (wanted < needed || !add_segment(wanted)) return nullptr;
  return carve(bytes, Segment::Where::anywhere);
}

// First what is in flight in sockets, then what still waits in this process's queues.
Block* SegmentMemoryImpl::revoke_and_carve(std::size_t bytes) {
  if (Block* block = revoke_blocks(bytes, false)) return block;
  return revoke_blocks(bytes, true);
}

Block* SegmentMemoryImpl::revoke_blocks(std::size_t bytes, bool with_handles) {
  for (Block* next = queue_.oldest(); next != nullptr;) {
    Block& block = *next;
    next = block.newer;
    Segment& segment = Segment::of(block);
    if (!block.sealed() || segment.has_handles(block) != with_handles || segment.taken_by_subscriber(block))
      continue;
    posix::step("allocate: revoking");
    segment.revoke(block);
    if (segment.in_use(block)) continue;
    take_back(block);
    ++stats_.revoked;
    if (Block* room = carve(bytes, Segment::Where::anywhere)) return room;
  }
  return nullptr;
}

bool SegmentMemoryImpl::add_segment(std::size_t size) {
  Expected<SegmentPtr> segment = Segment::create(size, options_.name, options_.prefault);
  if (segment) {
    segments_.push_back(std::move(*segment));
  } else {
    failure_ = segment.error();
  }
  return static_cast<bool>(segment);
}

// A publisher whose messages grew leaves its first segments behind; they make room for one that fits.
void SegmentMemoryImpl::drop_unused_segments() {
  const auto keep = [](const SegmentPtr& segment) { return !segment->unused(); };
  const auto unused = std::stable_partition(segments_.begin(), segments_.end(), keep);
  std::for_each(unused, segments_.end(), [](const SegmentPtr& segment) { segment->retire(); });
  segments_.erase(unused, segments_.end());
}

std::size_t SegmentMemoryImpl::first_size(std::size_t bytes) const {
  const std::size_t blocks = std::max(least_blocks, std::min<std::size_t>(options_.queue_size, 4096) + 2);
  const std::size_t block = bytes + block_header_bytes;
  const std::size_t wanted = block < options_.ceiling / blocks ? block * blocks : options_.ceiling;
  return std::max(segment_header_bytes + block, segment_header_bytes + wanted);
}

std::size_t SegmentMemoryImpl::total_size() const {
  std::size_t total = 0;
  for (const SegmentPtr& segment : segments_) total += segment->size();
  return total;
}

BufferPtr SegmentMemoryImpl::hand_out(Block& block) {
  queue_.push(block);
  stats_.used_bytes += block.size();
  ++stats_.used_blocks;
  ++stats_.allocated;
  return Segment::handle(block);
}

BufferPtr SegmentMemoryImpl::refuse(std::size_t bytes) {
  ++stats_.refused;
  const bool system_refused = failure_.code != 0;  // keeps the system's reason, once
  if (!system_refused)
    failure_.hint = "subscribers still use the older messages: give the publisher more memory";
  failure_.what =
      "allocate " + std::to_string(bytes) + " bytes" + (system_refused ? ": " + failure_.what : "");
  failure_.where = options_.name;
  last_ = failure_;
  failure_ = Error();
  return nullptr;
}

MemoryStats SegmentMemoryImpl::stats() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  MemoryStats stats = stats_;
  stats.segments = segments_.size();
  stats.size_bytes = total_size();
  for (const SegmentPtr& segment : segments_) stats.reserved_bytes += segment->reserved_bytes();
  return stats;
}

Error SegmentMemoryImpl::last_failure() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

}  // namespace segment
}  // namespace tzc
