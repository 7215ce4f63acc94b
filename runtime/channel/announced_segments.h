// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "segment/ledger.h"
#include "segment/received_segment.h"
#include "segment/segment.h"
#include "segment/segment_ptr.h"

namespace tzc {
namespace channel {

/// The segments that one subscriber was told about, with its ledger for each. Attached to their segments
/// until destroyed: as long as this object lives, what the subscriber holds is not reused. Not thread-safe.
class AnnouncedSegments {
 public:
  struct Entry {
    std::uint64_t id;
    segment::SegmentPtr segment;
    std::shared_ptr<segment::Ledger> ledger;
  };

  AnnouncedSegments() = default;
  AnnouncedSegments(const AnnouncedSegments&) = delete;
  AnnouncedSegments& operator=(const AnnouncedSegments&) = delete;
  ~AnnouncedSegments() { clear(); }

  std::size_t size() const { return entries_.size(); }
  /// Null: not announced yet. Valid until the next call that is not const.
  segment::Ledger* ledger_of(std::uint64_t segment_id) const {
    for (const Entry& entry : entries_) {
      if (entry.id == segment_id) return entry.ledger.get();
    }
    return nullptr;
  }
  /// Null: not announced, or the block is no more.
  BufferPtr revive(const segment::BlockRef& ref) const;
  Expected<Entry> add(segment::Segment& segment, const std::weak_ptr<segment::Revoker>& revoker);
  /// Lets go of segments that no block will ever be allocated in again and that the subscriber holds nothing
  /// of; returns their ids.
  std::vector<std::uint64_t> remove_retired();
  /// The subscriber is gone: it holds nothing any more.
  void clear();

 private:
  std::vector<Entry> entries_;
};

}  // namespace channel
}  // namespace tzc
