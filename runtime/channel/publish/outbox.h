// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <vector>

#include "channel/wire/record.h"
#include "channel/wire/wire.h"
#include "posix/hot.h"
#include "posix/packet.h"
#include "segment/ack_file.h"
#include "segment/block.h"
#include "segment/segment_ptr.h"

namespace tzc {
namespace channel {

/// An item to write: a record (in several packets when it is large) or a packet about segments.
struct Outgoing {
  PacketKind kind = PacketKind::record;
  RecordPtr record{};                            // record
  std::uint32_t sequence = 0;                    // record
  std::size_t written = 0;                       // record: bytes of its body already sent as fragments
  segment::SegmentPtr segment{};                 // segment
  std::shared_ptr<segment::AckFile> ack_file{};  // segment
  std::uint64_t segment_id = 0;                  // retire_segment
};

/// Counts of what went through the socket.
struct Traffic {
  std::uint64_t bytes = 0;
  std::uint32_t packets = 0;
};

/// Items that wait because the socket was full, in order. Not thread-safe.
class Outbox {
 public:
  /// Writes a record that fits in one packet and adds what it wrote to `traffic`.
  TZC_HOT static posix::SendResult write_record(int socket, const Record& record, std::uint32_t sequence,
                                                Traffic& traffic);
  /// Writes as much of `item` as the socket takes and adds what it wrote to `traffic`.
  static posix::SendResult write(int socket, Outgoing& item, Traffic& traffic);

  bool empty() const { return items_.empty(); }
  std::size_t size() const { return items_.size(); }
  std::size_t records() const { return records_; }
  void push(Outgoing item);
  /// Adds where the records have their handles of the block: two in a record that names it twice.
  void add_handles(const segment::BlockName& block, std::vector<const void*>& handles) const;
  /// Writes from the front until the socket is full or all is written.
  posix::SendResult flush(int socket, Traffic& traffic);
  /// Drops the records up to this one; the receiver skips a half-written one.
  void drop_records_through(std::uint32_t sequence);
  void clear();

 private:
  std::list<Outgoing> items_;  // a list that is empty, as usual, has no memory
  std::size_t records_ = 0;
};

}  // namespace channel
}  // namespace tzc
