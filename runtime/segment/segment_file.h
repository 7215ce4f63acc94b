// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "posix/mapping.h"
#include "segment/layout.h"
#include "segment/segment_pages.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// What lies where in the pages of a segment. Pages of headers and pages of payloads are each committed from the front, so
/// two marks tell which are. Not thread-safe.
class SegmentFile {
 public:
  /// Holds so many bytes of payload, and the headers on top.
  static Expected<SegmentFile> create(std::size_t payload_bytes, Prefault prefault, bool pooled);

  /// Commits the header of that slot and all payload pages below `end`: no write there can fail or fault on a full
  /// system.
  Status commit(std::uint32_t slot, std::uint64_t end);

  /// Which file they are in, and where.
  const SegmentPages& pages() const { return pages_; }
  std::uint8_t* data() const { return pages_.mapping().data(); }
  std::size_t size() const { return pages_.mapping().size(); }
  /// Most blocks at a time.
  std::uint32_t slots() const { return slots_; }
  std::uint64_t payloads_begin() const { return payloads_offset(slots_, posix::page_size()); }
  /// The largest payload that the file has room for.
  std::size_t payload_bytes() const { return size() - static_cast<std::size_t>(payloads_begin()); }
  /// Payloads that end there or below lie in committed pages.
  std::uint64_t payloads_committed() const { return payloads_.end; }
  std::size_t committed_bytes() const {
    return headers_.end + (payloads_.end - static_cast<std::size_t>(payloads_begin()));
  }

 private:
  struct Committed {
    std::size_t end = 0;
  };
  Status commit(Committed& part, std::size_t end);

  SegmentPages pages_;
  Prefault prefault_ = Prefault::none;
  std::uint32_t slots_ = 0;
  Committed headers_;
  Committed payloads_;
};

}  // namespace segment
}  // namespace tzc
