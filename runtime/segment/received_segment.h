// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>

#include "posix/file_descriptor.h"
#include "posix/hot.h"
#include "posix/mapping.h"
#include "segment/block.h"
#include "segment/layout.h"
#include "tzc/error.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// A publisher's announcement of a segment, as it crossed the socket. Not trusted.
struct SegmentOffer {
  std::uint64_t id;
  std::uint64_t size;
  std::uint64_t ack_size;
  std::uint32_t slots;
};

/// A reference to a block, as it crossed the socket. Not trusted.
struct BlockRef {
  std::uint64_t segment;
  std::uint64_t offset;  // of the payload in the segment
  std::uint64_t size;    // usable payload bytes
  std::uint32_t slot;
  std::uint32_t generation;
};

/// The subscriber's side of a segment: its data mapped read-only, its acknowledgements read-write.
/// Thread-safe. Whatever the peer sent or writes meanwhile, nothing here reads or writes outside the two
/// mappings.
class ReceivedSegment {
 public:
  /// Error: sizes that don't agree, files that are not sealed, a header of another version.
  static Expected<std::shared_ptr<ReceivedSegment>> open(const SegmentOffer& offer,
                                                         posix::FileDescriptor data,
                                                         posix::FileDescriptor acknowledgements);
  ReceivedSegment() = default;
  ~ReceivedSegment();

  std::uint64_t id() const { return id_; }
  /// True when the reference lies in this segment and the block there is the one it names.
  TZC_HOT bool check(const BlockRef& ref) const;
  /// The bytes of a reference that check() accepted.
  TZC_HOT ConstBlock block(const BlockRef& ref) const;
  /// In flight -> taken. False: the block was not in flight to us, or another one lives there now.
  TZC_HOT bool take(const BlockRef& ref);
  TZC_HOT void release(const BlockRef& ref);

 private:
  std::atomic<std::uint64_t>& word(std::uint32_t slot) const;
  AckHeader& header() const;

  std::uint64_t id_ = 0;
  std::uint32_t slots_ = 0;
  posix::Mapping data_;
  posix::Mapping acknowledgements_;
};

/// What open() checks in the first bytes of a received data file.
bool check_segment_header(const std::uint8_t* bytes, const SegmentOffer& offer);

}  // namespace segment
}  // namespace tzc
