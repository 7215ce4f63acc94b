// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment_list.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "posix/mapping.h"

namespace tzc {
namespace segment {
namespace {

/// Address space, memory of the machine, of the control group or below the ceiling; room in the file system; the size of files. Of
/// descriptors a smaller segment takes as many.
bool may_be_of_size(const Error& error) {
  return error.code == ENOMEM || error.code == ENOSPC || error.code == EFBIG;
}

constexpr std::size_t least_blocks = 4;

/// For how many blocks that lie elsewhere an empty segment stays.
///
/// One that comes back costs a fault for each of its pages, and a mapping in each subscriber. Publishing a message costs about as
/// much as faulting 32 pages. So a publisher that sends a large message now and then pays at most about as much for a segment
/// that comes and goes as for publishing the small ones in between; where large ones come sooner it pays nothing.
std::uint64_t patience(const Segment& segment) {
  constexpr std::uint64_t least = 512;
  constexpr std::uint64_t pages_per_block = 32;
  return least + segment.file().committed_bytes() / posix::page_size() / pages_per_block;
}

}  // namespace

std::size_t first_size(std::size_t bytes, const MemoryOptions& options) {
  const std::size_t blocks = std::max(least_blocks, std::min<std::size_t>(options.queue_size, 4096) + 2);
  return std::max(bytes, bytes < options.ceiling / blocks ? bytes * blocks : options.ceiling);
}

SegmentList::~SegmentList() {
  for (const Entry& entry : entries_) entry->retire();
}

std::size_t SegmentList::total_size() const {
  std::size_t total = 0;
  for (const Entry& entry : entries_) total += entry->file().size();
  return total;
}

Block* SegmentList::allocate_in(Entry& entry, std::size_t bytes, Segment::Where where, Error& failure) {
  Block* const block = entry->allocate_block(bytes, where, failure);
  if (block != nullptr) entry.used_at = ++allocated_;
  return block;
}

Block* SegmentList::allocate_block(std::size_t bytes, Segment::Where where, Error& failure) {
  for (Entry& entry : entries_) {
    if (entry.is_left) continue;
    if (Block* block = allocate_in(entry, bytes, where, failure)) return block;
  }
  if (where == Segment::Where::touched_memory) return nullptr;
  for (Entry& entry : entries_) {
    if (!entry.is_left) continue;
    if (Block* block = allocate_in(entry, bytes, where, failure)) return block;
  }
  return nullptr;
}

Status SegmentList::add(std::size_t bytes) {
  Expected<SegmentPtr> segment = Segment::create(bytes, options_);
  if (!segment) return segment.error();
  entries_.push_back(Entry{std::move(*segment), allocated_});
  return Success{};
}

// Memory that is short for good is asked for now and then, not for each message; where it comes back the segments grow again.
Status SegmentList::add_up_to(std::size_t wanted, std::size_t least) {
  if (least >= short_.least && short_.calls_to_skip > 0) {
    --short_.calls_to_skip;
    return short_.error;
  }
  std::size_t size = std::max(least, std::min(wanted, 2 * possible_));
  Status added = add(size);
  while (!added && may_be_of_size(added.error())) {
    short_.error = added.error();
    if (size == least) return note_shortage(least / 2, least);
    size = std::max(least, size / 2);
    added = add(size);
  }
  if (!added) return added;
  if (size < wanted) return share(size, least);
  possible_ = no_limit;
  return added;
}

// Of what is left the rest of the process, which is short of it, too, keeps half; and a memory that has more than is left gets no
// more: what does not fit is sent serialized, which takes memory as well.
Status SegmentList::share(std::size_t possible, std::size_t least) {
  entries_.pop_back();
  if (total_size() > possible) return note_shortage(possible, least);
  possible_ = possible;
  return add(std::max(least, possible / 2));
}

Status SegmentList::note_shortage(std::size_t possible, std::size_t least) {
  possible_ = possible;
  short_.least = least;
  short_.calls_to_skip = calls_between_requests;
  return short_.error;
}

template <class Predicate>
void SegmentList::drop(Predicate goes) {
  const auto gone = std::stable_partition(entries_.begin(), entries_.end(),
                                          [&goes](const Entry& entry) { return !goes(entry); });
  std::for_each(gone, entries_.end(), [](const Entry& entry) { entry->retire(); });
  entries_.erase(gone, entries_.end());
}

// A publisher whose messages grew leaves its first segments behind; they make room for one that fits.
void SegmentList::drop_unused() {
  drop([](const Entry& entry) { return entry->unused(); });
}

// One whose messages became small again leaves the large segments behind, or those of a burst.
void SegmentList::look_for_idle() {
  leave_large_segments();
  drop([this](const Entry& entry) {
    return entry->unused() && allocated_ != entry.used_at &&
           (entry.is_left || allocated_ - entry.used_at > patience(*entry.segment));
  });
}

// Or small messages lie in a large segment, of which nearly all pages are not needed any more: then a new one takes their place, and
// the large one goes with the last block that lies there. That, too, waits for as long as its pages are worth. The two together may be larger than
// the ceiling for so long, their pages are not.
void SegmentList::leave_large_segments() {
  constexpr std::size_t far_more = 4, always_fine = std::size_t{1} << 20;
  if (options_.size != 0 || guard::active) return;
  std::size_t committed = 0;
  std::uint64_t wait = 0;
  for (const Entry& entry : entries_) {
    committed += entry->file().committed_bytes();
    wait = std::max(wait, patience(*entry.segment));
  }
  if (allocated_ - recent_.since <= wait) return;
  const std::size_t needed = std::max(first_size(recent_.largest, options_), 2 * recent_.most_used);
  recent_ = Recent{allocated_, 0, 0};
  if (committed <= far_more * needed + always_fine || committed + needed > options_.ceiling) return;
  for (Entry& entry : entries_) entry.is_left = true;
  if (!add(needed))
    for (Entry& entry : entries_) entry.is_left = false;
}

}  // namespace segment
}  // namespace tzc
