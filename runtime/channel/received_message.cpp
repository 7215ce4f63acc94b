// SPDX-License-Identifier: BSD-3-Clause
#include "channel/received_message.h"

#include <cstring>

#include "posix/step.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::size_t usual_blocks = 2;

}  // namespace

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

ReceivedMessage::ReceivedMessage(std::shared_ptr<const Link> link) : link_(std::move(link)) {
  blocks_.reserve(usual_blocks);
}

// A forked child's copy says nothing: the blocks are its parent's.
ReceivedMessage::~ReceivedMessage() {
  if (!link_->forked()) release_blocks();
}

const std::uint8_t* ReceivedMessage::adopt(std::vector<std::uint8_t> body) {
  body_ = std::move(body);
  return body_.data();
}

void ReceivedMessage::hold(std::shared_ptr<segment::ReceivedSegment> segment, const segment::BlockRef& ref) {
  holds_.push_back(Hold{std::move(segment), ref});
}

void ReceivedMessage::release_blocks() {
  for (const Hold& hold : holds_) {
    posix::step("release: block");
    hold.segment->release(hold.ref);
    posix::step("release: released");
  }
  holds_.clear();
}

void ReceivedMessage::complete(const ParsedBody& parsed) {
  tag_ = parsed.header.tag;
  control_size_ = static_cast<std::size_t>(parsed.header.control_size);
  for (const Hold& hold : holds_) blocks_.push_back(hold.segment->block(hold.ref));
  control_ = parsed.control;
  if (control_ != nullptr) return;
  control_ = blocks_.back().data;
  blocks_.pop_back();
}

}  // namespace channel
}  // namespace tzc
