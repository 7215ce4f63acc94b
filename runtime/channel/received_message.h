// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "channel/few.h"
#include "channel/link.h"
#include "channel/wire.h"
#include "posix/hot.h"
#include "segment/received_segment.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

/// A body's parts, checked against its length; they point into the body, which is aligned to 8 bytes.
struct ParsedBody {
  BodyHeader header;
  const segment::BlockRef* refs;  // header.block_count of them
  const std::uint8_t* control;    // null: in the last block
};

/// False: malformed.
TZC_HOT bool parse_body(const std::uint8_t* data, std::size_t size, ParsedBody& parsed);

/// A message, first as memory for a packet that is still to come: everything a usual message needs is
/// allocated before the reader waits, nothing between its waking up and the callback. The blocks that it
/// holds are released when it is destroyed.
class ReceivedMessage final : public Message {
 public:
  TZC_HOT explicit ReceivedMessage(std::shared_ptr<const Link> link);
  TZC_HOT ~ReceivedMessage() override;

  /// Where the first packet_bytes of a packet go. Aligned to 8 bytes.
  static constexpr std::size_t packet_bytes = 768;
  std::uint8_t* packet() { return packet_; }
  /// A body that does not lie in the packet.
  const std::uint8_t* adopt(std::vector<std::uint8_t> body);

  /// A block that is taken already.
  TZC_HOT void hold(std::shared_ptr<segment::ReceivedSegment> segment, const segment::BlockRef& ref);
  TZC_HOT void release_blocks();
  /// `parsed` points into the packet or the adopted body; all its blocks are held.
  TZC_HOT void complete(const ParsedBody& parsed);

 private:
  struct Hold {
    std::shared_ptr<segment::ReceivedSegment> segment;
    segment::BlockRef ref;
  };

  const std::shared_ptr<const Link> link_;
  Few<Hold, 2> holds_;  // an image has one block, and one more for a control part that is large
  std::vector<std::uint8_t> body_;
  alignas(8) std::uint8_t packet_[packet_bytes];  // not initialised: the kernel fills it
};

}  // namespace channel
}  // namespace tzc
