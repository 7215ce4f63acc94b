// SPDX-License-Identifier: BSD-3-Clause
#include "channel/subscribe/received_message.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <utility>

#include "channel/inspection.h"
#include "channel/wire/recycled.h"
#include "posix/write_fault.h"
#include "segment/layout.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::size_t usual_blocks = 2;
constexpr std::size_t most_kept_blocks = 64;

// Of messages that came to an end. Never destroyed: a message may end after the program's statics.
Spares<std::vector<ConstBlock>, most_spares>& spare_lists() {
  static auto* const lists = new Spares<std::vector<ConstBlock>, most_spares>;
  return *lists;
}

std::size_t aligned(std::size_t bytes) {
  return (bytes + segment::cache_line - 1) / segment::cache_line * segment::cache_line;
}

std::uintptr_t address_of(const std::uint8_t* memory) {
  return reinterpret_cast<std::uintptr_t>(memory);
}

}  // namespace

ReceivedMessage::ReceivedMessage(std::shared_ptr<const Link> link) : link_(std::move(link)) {
  if (!spare_lists().take(blocks_)) blocks_.reserve(usual_blocks);
}

// A forked child's copy releases nothing: the blocks are its parent's.
ReceivedMessage::~ReceivedMessage() {
  if (!link_->forked()) release_blocks();
  if (blocks_.capacity() > most_kept_blocks) return;
  blocks_.clear();
  spare_lists().put(blocks_);
}

const std::uint8_t* ReceivedMessage::adopt(std::vector<std::uint8_t> body) {
  body_ = std::move(body);
  return body_.data();
}

void ReceivedMessage::hold(std::shared_ptr<segment::ReceivedSegment> segment, const segment::BlockRef& ref) {
  Hold hold{std::move(segment), ref, {nullptr, 0}};
  hold.segment->begin_view(ref, hold.view);
  holds_.push_back(std::move(hold));
}

void ReceivedMessage::release_blocks() {
  for (const Hold& hold : holds_) {
    if (hold.view.data != nullptr && hold.segment->end_view(hold.ref)) ++link_->written();
    sync_point("release: block");
    hold.segment->release(hold.ref);
    sync_point("release: released");
  }
  holds_.clear();
}

// What may be written to is never read where others read it. A payload without pages of its own (small) is copied; so is
// one that another message has a view of, because that view may have been written to.
bool ReceivedMessage::is_copied(const Hold& hold) const {
  return hold.view.data == nullptr && hold.segment->writes() != segment::ViewWrites::fault;
}

bool ReceivedMessage::has_views() const {
  return std::any_of(holds_.begin(), holds_.end(),
                     [](const Hold& hold) { return hold.view.data != nullptr; });
}

std::size_t ReceivedMessage::bytes_to_copy() const {
  std::size_t bytes = 0;
  for (const Hold& hold : holds_) {
    if (!is_copied(hold)) continue;
    bytes += aligned(static_cast<std::size_t>(hold.ref.size));
    if (bytes > SIZE_MAX / 4) throw std::bad_alloc();  // a peer's sizes: their sum must not wrap around
  }
  return bytes;
}

ConstBlock ReceivedMessage::bytes_of(const Hold& hold, std::uint8_t*& copy) const {
  if (hold.view.data != nullptr) return hold.view;
  const ConstBlock original = hold.segment->block(hold.ref);
  if (!is_copied(hold)) return original;
  std::memcpy(copy, original.data, original.size);
  copy += aligned(original.size);
  return ConstBlock{copy - aligned(original.size), original.size};
}

void ReceivedMessage::complete(const ParsedBody& parsed) {
  tag_ = parsed.header.tag;
  control_size_ = static_cast<std::size_t>(parsed.header.control_size);
  std::uint8_t* copy = nullptr;
  if (const std::size_t bytes = bytes_to_copy()) {
    copies_.reset(static_cast<std::uint8_t*>(std::malloc(bytes + segment::cache_line)));
    if (!copies_) throw std::bad_alloc();
    copy = copies_.get() + (segment::cache_line - address_of(copies_.get()) % segment::cache_line);
  }
  for (const Hold& hold : holds_) blocks_.push_back(bytes_of(hold, copy));
  if (has_views() && !link_->view_use().handed_over) posix::keep_watching_write_faults();
  control_ = parsed.control;
  if (control_ != nullptr) return;
  control_ = blocks_.back().data;
  blocks_.pop_back();
}

// There is no other implementation.
std::uint64_t trace_id(const Message& message) {
  return static_cast<const ReceivedMessage&>(message).trace_id();
}

}  // namespace channel
}  // namespace tzc
