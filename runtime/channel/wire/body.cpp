// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wire/body.h"

#include <cstring>

namespace tzc {
namespace channel {

bool parse_body(const std::uint8_t* data, std::size_t size, ParsedBody& parsed) {
  if (size < sizeof parsed.header) return false;
  std::memcpy(&parsed.header, data, sizeof parsed.header);
  const std::uint64_t count = parsed.header.block_count;
  if (count > max_refs) return false;
  const std::uint64_t refs_end = sizeof parsed.header + count * sizeof(segment::BlockRef);
  if (refs_end > size) return false;
  parsed.refs = reinterpret_cast<const segment::BlockRef*>(data + sizeof parsed.header);
  const bool in_block = (parsed.header.flags & control_in_last_block) != 0;
  parsed.control = in_block ? nullptr : data + refs_end;
  if (in_block)
    return refs_end == size && count > 0 && parsed.header.control_size <= parsed.refs[count - 1].size;
  return parsed.header.control_size == size - refs_end;
}

}  // namespace channel
}  // namespace tzc
