// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

namespace tzc {
namespace segment {

class Segment;

/// Keeps a segment mapped. Counts in the segment itself, together with its blocks' handles.
class SegmentPtr {
 public:
  SegmentPtr() noexcept = default;
  explicit SegmentPtr(Segment* segment) noexcept;
  SegmentPtr(const SegmentPtr& other) noexcept : SegmentPtr(other.segment_) {}
  SegmentPtr(SegmentPtr&& other) noexcept : segment_(std::exchange(other.segment_, nullptr)) {}
  SegmentPtr& operator=(SegmentPtr other) noexcept {
    std::swap(segment_, other.segment_);
    return *this;
  }
  ~SegmentPtr();

  Segment* get() const noexcept { return segment_; }
  Segment* operator->() const noexcept { return segment_; }
  Segment& operator*() const noexcept { return *segment_; }
  explicit operator bool() const noexcept { return segment_ != nullptr; }

 private:
  Segment* segment_ = nullptr;
};

}  // namespace segment
}  // namespace tzc
