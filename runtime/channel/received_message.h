// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "channel/link.h"
#include "channel/wire.h"
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
bool parse_body(const std::uint8_t* data, std::size_t size, ParsedBody& parsed);

/// A message whose blocks are taken: they are released when it is destroyed.
class ReceivedMessage final : public Message {
 public:
  struct Hold {
    std::shared_ptr<segment::ReceivedSegment> segment;
    segment::BlockRef ref;
  };

  /// `body` is what `parsed` points into. The holds must be taken already.
  ReceivedMessage(std::vector<std::uint8_t> body, const ParsedBody& parsed, std::vector<Hold> holds,
                  std::shared_ptr<const Link> link);
  ~ReceivedMessage() override;

 private:
  const std::vector<std::uint8_t> body_;
  std::vector<Hold> holds_;
  const std::shared_ptr<const Link> link_;
};

}  // namespace channel
}  // namespace tzc
