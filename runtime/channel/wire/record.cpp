// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wire/record.h"

#include <cstring>
#include <string>

#include "channel/wire/age_stamp.h"
#include "channel/wire/body.h"
#include "channel/wire/recycled.h"
#include "channel/wire/ring.h"
#include "posix/hot.h"
#include "segment/segment.h"

namespace tzc {
namespace channel {
namespace {

// What a slot of the ring takes beside the packet's prefix. All else would go through the socket.
constexpr std::size_t most_in_ring = slot_bytes - sizeof(RecordPrefix);
constexpr std::size_t max_control_bytes = max_body_bytes / 2;

TZC_HOT segment::BlockRef reference_to(const Buffer& buffer) {
  const segment::Segment& owner = segment::Segment::of(buffer);
  const segment::BlockName name = segment::Segment::name_of(buffer);
  const auto offset = static_cast<std::uint64_t>(buffer.data() - owner.file().data());
  return segment::BlockRef{name.segment, offset, buffer.size(), name.slot, name.generation};
}

std::size_t inlined_control_size(const BodyHeader& header) {
  const bool in_block = (header.flags & control_in_last_block) != 0;
  return in_block ? 0 : static_cast<std::size_t>(header.control_size);
}

TZC_HOT bool fits_ring(const BodyHeader& header) {
  const std::size_t refs = header.block_count * sizeof(segment::BlockRef);
  return sizeof header + refs + static_cast<std::size_t>(header.control_size) <= most_in_ring;
}

// A block of its own only helps if the reference to it goes where the control part does not.
TZC_HOT BufferPtr control_block(const BodyHeader& header, const void* control, MemorySource* memory) {
  if (memory == nullptr || fits_ring(header)) return nullptr;
  const auto size = static_cast<std::size_t>(header.control_size);
  if (size <= sizeof(segment::BlockRef)) return nullptr;
  BufferPtr block = memory->allocate(size);
  if (block) std::memcpy(block->data(), control, size);
  return block;
}

std::uint8_t* append(std::uint8_t* at, const void* data, std::size_t size) {
  if (size > 0) std::memcpy(at, data, size);
  return at + size;
}

TZC_HOT bool all_valid(BufferSpan buffers) {
  for (const BufferPtr& buffer : buffers) {
    if (!buffer || buffer->inherited()) return false;
  }
  return buffers.size() < max_refs;
}

}  // namespace

Record::Record(const BodyHeader& header, const void* control, BufferSpan buffers,
               const BufferPtr& control_block)
    : size_(sizeof header + header.block_count * sizeof(segment::BlockRef) + inlined_control_size(header)),
      large_(size_ > usual_bytes ? new std::uint8_t[size_] : nullptr) {
  for (const BufferPtr& buffer : buffers) buffers_.push_back(buffer);
  if (control_block) buffers_.push_back(control_block);
  std::uint8_t* at = append(large_ ? large_.get() : small_, &header, sizeof header);
  for (const BufferPtr& buffer : buffers_) {
    const segment::BlockRef ref = reference_to(*buffer);
    at = append(at, &ref, sizeof ref);
  }
  append(at, control, inlined_control_size(header));
}

Status can_carry(std::size_t control_size, std::size_t buffer_count) {
  Error error;
  if (buffer_count >= max_refs) {
    error.what = "send a message of " + std::to_string(buffer_count) + " separate arrays";
    error.hint = "a message refers to at most " + std::to_string(max_refs - 1) +
                 ": put several of them into one array, or send it without shared memory";
  } else if (control_size > max_control_bytes) {
    error.what = "send a message with a control part of " + std::to_string(control_size) + " bytes";
    error.hint = "it has at most 1 GiB besides its arrays: move large fields into arrays";
  } else {
    return Success{};
  }
  return error;
}

TZC_HOT RecordPtr make_record(std::uint32_t tag, const void* control, std::size_t control_size,
                              BufferSpan buffers, MemorySource* memory) {
  if (!all_valid(buffers) || control_size > max_control_bytes) return nullptr;
  for (const BufferPtr& buffer : buffers) buffer->seal();
  BodyHeader header{tag, 0, static_cast<std::uint32_t>(buffers.size()), age_stamp(), control_size};
  const BufferPtr block = control_block(header, control, memory);
  if (!block) return make_recycled<const Record>(header, control, buffers);
  block->seal();
  header.flags = control_in_last_block;
  ++header.block_count;
  return make_recycled<const Record>(header, control, buffers, block);
}

RecordParts parts_of(const Record& record) {
  ParsedBody parsed{};
  parse_body(record.data(), record.size(), parsed);
  RecordParts parts{
      parsed.header.tag, parsed.control, static_cast<std::size_t>(parsed.header.control_size), {}};
  for (const BufferPtr& buffer : record.buffers())
    parts.blocks.push_back(ConstBlock{buffer->data(), buffer->size()});
  if (parts.control != nullptr) return parts;
  parts.control = parts.blocks.back().data;
  parts.blocks.pop_back();
  return parts;
}

}  // namespace channel
}  // namespace tzc
