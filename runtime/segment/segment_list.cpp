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

SegmentList::~SegmentList() {
  for (const Entry& entry : entries_) entry->retire();
}

std::size_t SegmentList::total_size() const {
  std::size_t total = 0;
  for (const Entry& entry : entries_) total += entry->file().size();
  return total;
}

Block* SegmentList::allocate_block(std::size_t bytes, Segment::Where where, Error& failure) {
  for (Entry& entry : entries_) {
    Block* block = entry->allocate_block(bytes, where, failure);
    if (block == nullptr) continue;
    entry.used_at = ++allocated_;
    return block;
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
  drop([this](const Entry& entry) {
    return entry->unused() && allocated_ - entry.used_at > patience(*entry.segment);
  });
}

}  // namespace segment
}  // namespace tzc
