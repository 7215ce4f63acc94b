// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "channel/publish/announced_segments.h"
#include "channel/publish/in_flight_records.h"
#include "channel/wire/record.h"
#include "channel/wire/shared_page.h"
#include "posix/hot.h"

namespace tzc {
namespace channel {

/// How many records may be in flight to one subscriber.
struct InFlightLimit {
  std::size_t records;         ///< at least 1
  std::size_t buffered_bytes;  ///< PublisherOptions::buffered_bytes

  /// Records that may be in flight whatever their size.
  std::size_t of_any_size() const;
  /// However small they are.
  std::size_t most() const;
};

/// The records in flight to one subscriber: their marks in its ack files, and who gets them
/// (channel/wire/delivery_cursors.h). Not thread-safe; the page and the segments outlive it.
class InFlightWindow {
 public:
  /// `retains`: take_undelivered returns the records that are in flight at the end.
  InFlightWindow(const SharedPage& page, AnnouncedSegments& segments, InFlightLimit limit, bool retains);

  const InFlightLimit& limit() const { return limit_; }
  std::size_t size() const { return records_.size(); }
  std::uint32_t last_sequence() const { return last_sequence_; }
  /// Records up to this one that were not taken are revoked and need not be sent any more.
  std::uint32_t revoked_through() const { return revoked_through_; }
  /// Records that were revoked.
  std::uint64_t dropped() const { return drops_.queue + drops_.memory + drops_.end; }
  struct Drops {
    std::uint64_t queue = 0;   ///< too many were in flight
    std::uint64_t memory = 0;  ///< a block of theirs was needed
    std::uint64_t end = 0;     ///< the deliveries ended
  };
  const Drops& drops() const { return drops_; }
  /// Of the blocks of all records so far.
  std::uint64_t shared_bytes() const { return shared_bytes_; }

  /// Marks the record's blocks for the subscriber. Before the record is written: once the subscriber can know of
  /// a block, the block must be kept for it.
  TZC_HOT void push(const RecordPtr& record);
  /// Drops the records that the subscriber took. False: it claims to have taken one that was never sent.
  TZC_HOT bool retire_taken();
  /// With size() at InFlightLimit::of_any_size() or more: revokes the oldest records until the limit allows one more. False: the subscriber does not keep to the protocol.
  TZC_HOT bool make_room();
  /// Revokes what is in flight by the grace of buffered_bytes. False: as above.
  bool revoke_buffered();
  /// Revokes each record that refers to the block, and those before it. False: as above.
  bool revoke_block(const segment::BlockName& block);
  /// Revokes everything that the subscriber did not take: it takes nothing more. False: as above.
  bool end();
  std::vector<RecordPtr> take_undelivered() { return std::move(undelivered_); }

 private:
  struct Counted;

  bool is_full() const;
  std::size_t beyond(std::size_t most) const { return size() > most ? size() - most : 0; }
  bool revoke_through(std::uint32_t sequence, std::uint64_t& drops);
  void drop_oldest();
  void revoke_oldest(std::uint64_t& drops);
  bool rebuild(const InFlightRecords::Entry& entry);

  const SharedPage& page_;
  AnnouncedSegments& segments_;
  const InFlightLimit limit_;
  const bool retains_;
  std::uint32_t last_sequence_;
  std::uint32_t revoked_through_;
  Drops drops_;
  std::uint64_t shared_bytes_ = 0;
  InFlightRecords records_;
  std::size_t buffered_bytes_ =
      0;  // of the records before the youngest that the limit allows in any size, but one
  std::vector<RecordPtr> undelivered_;
};

/// Sequence numbers start shortly before they wrap around, so that every run exercises it (decision 105).
constexpr std::uint32_t first_sequence = 0xffffffff - 5;

}  // namespace channel
}  // namespace tzc
