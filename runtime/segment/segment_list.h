// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "segment/segment.h"
#include "segment/segment_ptr.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// The segments of one memory: how large a new one is where the system does not give what is wanted, and when one goes. Used by
/// one allocator at a time.
class SegmentList {
 public:
  struct Entry {
    SegmentPtr segment;
    std::uint64_t used_at;  ///< the memory's count of blocks when the latest one was allocated there
    bool is_left = false;   ///< far larger than what is needed now: used only where no other has room
    Segment* operator->() const noexcept { return segment.get(); }
  };
  using Entries = std::vector<Entry>;

  explicit SegmentList(const MemoryOptions& options) : options_(options) {}
  ~SegmentList();
  SegmentList(const SegmentList&) = delete;
  SegmentList& operator=(const SegmentList&) = delete;

  Entries::const_iterator begin() const { return entries_.begin(); }
  Entries::const_iterator end() const { return entries_.end(); }
  std::size_t count() const { return entries_.size(); }
  std::size_t total_size() const;

  /// In the first segment that has room. Errors other than "no room" go to `failure`.
  Block* allocate_block(std::size_t bytes, Segment::Where where, Error& failure);
  /// Adds a segment of exactly so many bytes.
  Status add(std::size_t bytes);
  /// Adds one of `wanted` bytes, or of fewer where the system has not got so many, but of `least` at least. Error: what the
  /// system last said.
  Status add_up_to(std::size_t wanted, std::size_t least);
  /// Lets go of all that are empty.
  void drop_unused();
  /// After each block that was allocated: `bytes` of it, `used` in all. Lets go of segments that are empty and have been so for long, and
  /// of pages that have long been far more than what is used. The segment of the latest block stays, so this never drops the last one.
  void note_allocated(std::size_t bytes, std::size_t used) {
    recent_.largest = std::max(recent_.largest, bytes);
    recent_.most_used = std::max(recent_.most_used, used);
    if (allocated_ % blocks_per_look == 0) look_for_idle();
  }

 private:
  static constexpr std::uint64_t blocks_per_look = 64;
  static constexpr unsigned calls_between_requests = 16;
  static constexpr std::size_t no_limit = SIZE_MAX / 2;  // twice that can be asked for

  struct Shortage {
    Error error;            ///< what the system last said to a size
    std::size_t least = 0;  ///< so much was needed, and not there
    unsigned calls_to_skip = 0;
  };

  /// What was allocated since the last look that came to a result.
  struct Recent {
    std::uint64_t since = 0;  ///< the count of blocks
    std::size_t largest = 0;
    std::size_t most_used = 0;
  };

  Block* allocate_in(Entry& entry, std::size_t bytes, Segment::Where where, Error& failure);
  Status share(std::size_t possible, std::size_t least);
  Status note_shortage(std::size_t possible, std::size_t least);
  template <class Predicate>
  void drop(Predicate goes);
  void look_for_idle();
  void leave_large_segments();

  const MemoryOptions& options_;
  Entries entries_;
  std::uint64_t allocated_ = 0;      ///< blocks
  std::size_t possible_ = no_limit;  ///< twice as much was refused when it was last asked for
  Shortage short_;
  Recent recent_;
};

/// For so many messages of that size there is room in a memory's first segment, or as the ceiling allows.
std::size_t first_size(std::size_t bytes, const MemoryOptions& options);

}  // namespace segment
}  // namespace tzc
