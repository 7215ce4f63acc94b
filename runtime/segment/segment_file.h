// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "segment/layout.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// A segment's memory file and its mapping. Pages of headers and pages of payloads are each committed from the front, so
/// two marks tell which are. Not thread-safe.
class SegmentFile {
 public:
  /// Holds so many bytes of payload, and the headers on top.
  static Expected<SegmentFile> create(std::size_t payload_bytes, Prefault prefault);

  /// Commits the header of that slot and all payload pages below `end`: no write there can fail or fault on a full
  /// system.
  Status commit(std::uint32_t slot, std::uint64_t end);

  /// In a forked child, whose writes must not reach the parent's messages.
  void make_private() const noexcept { mapping_.make_private(file_.descriptor.get()); }

  std::uint8_t* data() const { return mapping_.data(); }
  std::size_t size() const { return mapping_.size(); }
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
  /// What subscribers get.
  int fd() const { return file_.shared_fd(); }

 private:
  struct Committed {
    std::size_t end = 0;
  };
  Status commit(Committed& part, std::size_t end);

  posix::MemoryFile file_;
  posix::Mapping mapping_;
  Prefault prefault_ = Prefault::none;
  std::uint32_t slots_ = 0;
  Committed headers_;
  Committed payloads_;
};

}  // namespace segment
}  // namespace tzc
