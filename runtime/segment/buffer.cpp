// SPDX-License-Identifier: BSD-3-Clause
#include "posix/fork_epoch.h"
#include "segment/segment.h"
#include "tzc/memory.h"

namespace tzc {

bool Buffer::inherited() const noexcept {
  return posix::forked_since(segment_->epoch_);
}

// From here on the allocator may reuse the block; only the reference to the segment keeps this memory valid.
void Buffer::release_last() noexcept {
  segment_->note_release(slot_);
  segment_->drop_user();
}

void Buffer::guard_published() noexcept {
  if (segment_->guard() != nullptr) segment_->guard()->publish(static_cast<const segment::Block&>(*this));
}

namespace segment {

SegmentPtr::SegmentPtr(Segment* segment) noexcept : segment_(segment) {
  if (segment_) segment_->add_user();
}

SegmentPtr::~SegmentPtr() {
  if (segment_) segment_->drop_user();
}

}  // namespace segment
}  // namespace tzc
