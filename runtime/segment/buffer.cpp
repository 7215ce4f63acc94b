// SPDX-License-Identifier: BSD-3-Clause
#include "segment/segment.h"
#include "tzc/memory.h"

namespace tzc {

// From here on the allocator may reuse the block; only the claim on the segment keeps this memory valid.
void Buffer::release_last() noexcept {
  segment_->count_release();
  segment_->drop_user();
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
