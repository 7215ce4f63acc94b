// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include "posix/file_descriptor.h"
#include "posix/hot.h"
#include "posix/mapping.h"
#include "segment/ack_view.h"
#include "segment/block.h"
#include "segment/fork_copies.h"
#include "segment/layout.h"
#include "segment/private_views.h"
#include "tzc/error.h"
#include "tzc/memory.h"

namespace tzc {
namespace segment {

/// A publisher's announcement of a segment, as it crossed the socket. Not trusted.
struct SegmentOffer {
  std::uint64_t id;
  std::uint64_t size;
  std::uint64_t ack_size;
  std::uint64_t file_size;  // of the file that the segment is a part of
  std::uint64_t offset;     // there
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

/// What a write to a payload by this process does.
enum class ViewWrites {
  private_pages,  ///< changes pages of its own (private_views.h)
  copies,         ///< changes a copy: every payload is copied
  fault,          ///< is a SIGSEGV; nothing is copied
};

/// Why what a peer sent is no segment: its fault. Any other error is this process's own lack of something.
struct Refusal : Error {
  explicit Refusal(Error error) : Error(std::move(error)) {}
};

class ReceivedSegment;
using OpenedSegment = std::variant<std::shared_ptr<ReceivedSegment>, Refusal, Error>;

/// The subscriber's side of a segment: its data mapped read-only, once more for the views of payloads that have pages of
/// their own (private_views.h), and its acknowledgements read-write. Thread-safe. Whatever the peer sent or writes
/// meanwhile, nothing here reads or writes outside these mappings.
class ReceivedSegment final : public ForkCopied {
 public:
  /// Refusal: sizes that don't agree, files that are not sealed or not of the promised kind, a header of another version.
  /// Error: they may be what they should, and this process cannot map them.
  static OpenedSegment open(const SegmentOffer& offer, posix::FileDescriptor data,
                            posix::FileDescriptor acknowledgements,
                            ViewWrites writes = ViewWrites::private_pages, WriteListener* listener = nullptr);
  ReceivedSegment() = default;
  ~ReceivedSegment();

  std::uint64_t id() const { return id_; }
  /// True when the reference lies in this segment and the block there is the one it names.
  TZC_HOT bool check(const BlockRef& ref) const;
  /// The bytes of a reference that check() accepted, as the publisher wrote them.
  TZC_HOT ConstBlock block(const BlockRef& ref) const;
  ViewWrites writes() const { return writes_; }
  /// The same in a view that this process may write to. False: the payload has no pages of its own (small), another
  /// view of it lives, or there are no such views.
  TZC_HOT bool begin_view(const BlockRef& ref, ConstBlock& view);
  /// True: the view was written to. Before release().
  TZC_HOT bool end_view(const BlockRef& ref);
  /// In flight -> taken. False: the block was not in flight to us, or another one lives there now.
  TZC_HOT bool take(const BlockRef& ref);
  TZC_HOT void release(const BlockRef& ref);

  bool hold_for_child() noexcept override;
  bool copy_in_child() noexcept override { return views_->copy_in_child(); }
  void release_for_child() noexcept override;

 private:
  Status map_views(int fd, const SegmentOffer& offer, WriteListener* listener);
  void add_range(const std::uint8_t* begin) const;
  void add_views();
  void release(std::uint32_t slot, std::uint32_t generation);

  std::uint64_t id_ = 0;
  ViewWrites writes_ = ViewWrites::fault;
  posix::Mapping data_;
  std::unique_ptr<PrivateViews> views_;  // null: there are none
  posix::Mapping acknowledgements_;
  AckView acks_;
  std::vector<std::uint64_t> held_for_child_;  // a bit for each slot; empty: there are no views
};

/// What open() checks in the first bytes of a received data file.
bool check_segment_header(const std::uint8_t* bytes, const SegmentOffer& offer);

}  // namespace segment
}  // namespace tzc
