// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "channel/publish/packet_sender.h"
#include "channel/wire/record.h"
#include "segment/ack_file.h"
#include "segment/received_segment.h"
#include "segment/segment.h"
#include "segment/segment_ptr.h"

namespace tzc {
namespace channel {

/// The segments that were announced to one subscriber, with an ack file for each. While this object lives,
/// blocks that the subscriber holds are not reused. Not thread-safe.
class AnnouncedSegments {
 public:
  AnnouncedSegments() = default;
  AnnouncedSegments(const AnnouncedSegments&) = delete;
  AnnouncedSegments& operator=(const AnnouncedSegments&) = delete;
  ~AnnouncedSegments() { clear(); }

  /// True when every segment of the record is announced.
  TZC_HOT bool covers(const Record& record) const {
    return std::all_of(record.buffers().begin(), record.buffers().end(), [this](const BufferPtr& buffer) {
      return ack_file_of(segment::Segment::of(*buffer).id()) != nullptr;
    });
  }
  /// Retires unused segments, then announces those of the record that are not announced yet. Error: no
  /// descriptors or memory, or too many segments. `sent` is the sender's last result.
  Status announce(const Record& record, const std::weak_ptr<segment::Revoker>& revoker, PacketSender& sender,
                  PacketSender::Result& sent);

  /// Null: not announced yet. Valid until the next call that is not const.
  segment::AckFile* ack_file_of(std::uint64_t segment_id) const {
    const Entry* entry = find(segment_id);
    return entry == nullptr ? nullptr : entry->ack_file.get();
  }
  std::vector<std::shared_ptr<segment::AckFile>> ack_files() const;
  /// A new handle of a block that is in flight to the subscriber. Null: not announced, or the block was
  /// freed.
  BufferPtr revive(const segment::BlockRef& ref) const;
  /// Removes one mark. A retired segment has no mark, unless its subscriber forged one.
  void revoke(const segment::BlockName& block) const;
  /// The subscriber hung up: it holds nothing any more.
  void clear();

 private:
  struct Entry {
    std::uint64_t id;
    segment::SegmentPtr segment;
    std::shared_ptr<segment::AckFile> ack_file;
  };

  const Entry* find(std::uint64_t segment_id) const {
    for (const Entry& entry : entries_) {
      if (entry.id == segment_id) return &entry;
    }
    return nullptr;
  }
  Status add(segment::Segment& segment, const std::weak_ptr<segment::Revoker>& revoker);
  std::vector<std::uint64_t> remove_retired();

  std::vector<Entry> entries_;
};

}  // namespace channel
}  // namespace tzc
