// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <vector>

#include "channel/subscribe/link.h"
#include "channel/wire/body.h"
#include "channel/wire/small_vector.h"
#include "posix/hot.h"
#include "segment/received_segment.h"
#include "tzc/channel.h"

namespace tzc {
namespace channel {

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
  void traced_as(std::uint64_t id) { trace_id_ = id; }
  std::uint64_t trace_id() const { return trace_id_; }

 private:
  struct Hold {
    std::shared_ptr<segment::ReceivedSegment> segment;
    segment::BlockRef ref;
    ConstBlock view;  // null data: none, the bytes are elsewhere
  };
  struct Free {
    void operator()(std::uint8_t* memory) const { std::free(memory); }
  };

  bool is_copied(const Hold& hold) const;
  bool has_views() const;
  ConstBlock bytes_of(const Hold& hold, std::uint8_t*& copy) const;
  std::size_t bytes_to_copy() const;

  const std::shared_ptr<const Link> link_;
  SmallVector<Hold, 2> holds_;  // an image has one block, and one more for a control part that is large
  std::unique_ptr<std::uint8_t, Free> copies_;  // of blocks that this process may write to and have no view
  std::vector<std::uint8_t> body_;
  std::uint64_t trace_id_ = 0;
  alignas(8) std::uint8_t packet_[packet_bytes];  // not initialised: the kernel fills it
};

}  // namespace channel
}  // namespace tzc
