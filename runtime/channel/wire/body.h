// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "channel/wire/wire.h"
#include "posix/hot.h"
#include "segment/received_segment.h"

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

}  // namespace channel
}  // namespace tzc
