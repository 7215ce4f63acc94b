// SPDX-License-Identifier: BSD-3-Clause
#include "channel/record.h"

#include <cstring>

#include "channel/wire.h"
#include "segment/segment.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::size_t max_inline_control = 64 << 10;

segment::BlockRef reference_to(const Buffer& buffer) {
  const segment::Segment& owner = segment::Segment::of(buffer);
  const segment::BlockName name = segment::Segment::name_of(buffer);
  const auto offset = static_cast<std::uint64_t>(buffer.data() - owner.data());
  return segment::BlockRef{name.segment, offset, buffer.size(), name.slot, name.generation};
}

void append(std::vector<std::uint8_t>& bytes, const void* data, std::size_t size) {
  const auto* begin = static_cast<const std::uint8_t*>(data);
  bytes.insert(bytes.end(), begin, begin + size);
}

std::vector<std::uint8_t> encode_body(BodyHeader header, const std::vector<BufferPtr>& buffers,
                                      const void* control) {
  const bool inlined = (header.flags & control_in_last_block) == 0;
  const std::size_t control_size = inlined ? static_cast<std::size_t>(header.control_size) : 0;
  std::vector<std::uint8_t> body;
  body.reserve(sizeof header + buffers.size() * sizeof(segment::BlockRef) + control_size);
  append(body, &header, sizeof header);
  for (const BufferPtr& buffer : buffers) {
    const segment::BlockRef ref = reference_to(*buffer);
    append(body, &ref, sizeof ref);
  }
  append(body, control, control_size);
  return body;
}

BufferPtr control_block(const void* control, std::size_t size, MemorySource* memory) {
  if (memory == nullptr || size <= max_inline_control) return nullptr;
  BufferPtr block = memory->allocate(size);
  if (block) std::memcpy(block->data(), control, size);
  return block;
}

bool all_valid(const std::vector<BufferPtr>& buffers) {
  for (const BufferPtr& buffer : buffers) {
    if (!buffer) return false;
  }
  return buffers.size() < max_refs;
}

}  // namespace

RecordPtr make_record(std::uint32_t tag, const void* control, std::size_t control_size,
                      std::vector<BufferPtr> buffers, MemorySource* memory) {
  if (!all_valid(buffers) || control_size > max_body_bytes / 2) return nullptr;
  BodyHeader header{tag, 0, 0, 0, control_size};
  if (BufferPtr block = control_block(control, control_size, memory)) {
    buffers.push_back(std::move(block));
    header.flags = control_in_last_block;
  }
  header.block_count = static_cast<std::uint32_t>(buffers.size());
  for (const BufferPtr& buffer : buffers) buffer->seal();
  std::vector<std::uint8_t> body = encode_body(header, buffers, control);
  return std::make_shared<const Record>(std::move(body), std::move(buffers));
}

}  // namespace channel
}  // namespace tzc
