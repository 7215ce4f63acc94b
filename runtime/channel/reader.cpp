// SPDX-License-Identifier: BSD-3-Clause
#include "channel/reader.h"

#include <cstring>

#include "channel/verdict.h"
#include "channel/wire.h"
#include "posix/step.h"

namespace tzc {
namespace channel {
namespace {

template <class Packet>
bool read_packet(const std::vector<std::uint8_t>& memory, std::size_t size, Packet& packet) {
  if (size < sizeof packet) return false;
  std::memcpy(&packet, memory.data(), sizeof packet);
  return true;
}

}  // namespace

Reader::Reader(std::shared_ptr<const Link> link)
    : link_(std::move(link)), memory_(max_packet_bytes), last_sequence_(link_->first_sequence()) {}

Reader::Result Reader::read(posix::Waiting waiting, MessagePtr& message) {
  if (!reason_.empty()) return Result::closed;
  for (;;) {
    posix::ReceivedPacket packet;
    const auto result =
        posix::receive_packet(link_->fd(), memory_.data(), memory_.size(), waiting, true, packet);
    if (result == posix::ReceiveResult::nothing) return Result::nothing;
    if (result == posix::ReceiveResult::closed) {
      reason_ = "the publisher closed the connection";
      return Result::closed;
    }
    counters_.bytes += packet.size;
    if (!handle(packet, message)) return Result::closed;
    if (message) return Result::message;
  }
}

bool Reader::handle(posix::ReceivedPacket& packet, MessagePtr& message) {
  PacketKind kind{};
  if (packet.truncated || !read_packet(memory_, packet.size, kind)) return broken("a packet of a wrong size");
  switch (kind) {
    case PacketKind::segment:
      return open_segment(packet);
    case PacketKind::retire_segment:
      return retire_segment(packet);
    case PacketKind::record:
      return accept_record(packet, message);
    case PacketKind::fragment:
      return accept_fragment(packet, message);
    default:
      return broken("a packet of an unknown kind");
  }
}

bool Reader::open_segment(posix::ReceivedPacket& packet) {
  SegmentPacket offer{};
  if (packet.size != sizeof offer || !read_packet(memory_, packet.size, offer))
    return broken("a malformed segment");
  if (packet.descriptor_count != 2) return broken("a segment without its files (too many open files here?)");
  if (segments_.size() >= max_segments || segments_.count(offer.offer.id) != 0)
    return broken("too many segments");
  auto opened = segment::ReceivedSegment::open(offer.offer, std::move(packet.descriptors[0]),
                                               std::move(packet.descriptors[1]));
  if (!opened) return broken(opened.error().text());
  segments_.emplace(offer.offer.id, std::move(*opened));
  return true;
}

bool Reader::retire_segment(const posix::ReceivedPacket& packet) {
  RetireSegment retirement{};
  if (!read_packet(memory_, packet.size, retirement)) return broken("a malformed retirement");
  segments_.erase(retirement.id);
  return true;
}

bool Reader::accept_record(const posix::ReceivedPacket& packet, MessagePtr& message) {
  RecordPrefix prefix{};
  if (!read_packet(memory_, packet.size, prefix)) return broken("a malformed record");
  const auto begin = memory_.begin() + sizeof prefix;
  return deliver(prefix.sequence, {begin, memory_.begin() + static_cast<std::ptrdiff_t>(packet.size)},
                 message);
}

// Memory grows with what really arrived, never with what a peer merely announced.
bool Reader::accept_fragment(const posix::ReceivedPacket& packet, MessagePtr& message) {
  FragmentPrefix prefix{};
  if (!read_packet(memory_, packet.size, prefix)) return broken("a malformed fragment");
  const std::uint64_t slice = packet.size - sizeof prefix;
  if (prefix.offset == 0) {
    if (prefix.total > max_body_bytes) return broken("a message that is too large");
    assembly_ = Assembly{prefix.sequence, prefix.total, {}};
  }
  const bool fits = prefix.sequence == assembly_.sequence && prefix.total == assembly_.total &&
                    prefix.offset == assembly_.bytes.size() && slice > 0 &&
                    slice <= prefix.total - prefix.offset;
  if (!fits) return broken("fragments that don't fit together");
  assembly_.bytes.insert(assembly_.bytes.end(), memory_.begin() + sizeof prefix,
                         memory_.begin() + static_cast<std::ptrdiff_t>(packet.size));
  if (assembly_.bytes.size() < assembly_.total) return true;
  Assembly whole = std::move(assembly_);
  assembly_ = Assembly{};
  return deliver(whole.sequence, std::move(whole.bytes), message);
}

// Only the winner of the verdict looks at the blocks: those of a revoked record may hold something else by
// now.
bool Reader::deliver(std::uint32_t sequence, std::vector<std::uint8_t> body, MessagePtr& message) {
  ParsedBody parsed;
  if (!advance(sequence) || !parse_body(body.data(), body.size(), parsed))
    return broken("a malformed record");
  posix::step("take: before verdict");
  if (!win_take(link_->verdict(), sequence)) {
    ++counters_.lost;
    return true;
  }
  posix::step("take: verdict won");
  std::vector<ReceivedMessage::Hold> holds;
  if (!take(parsed, holds)) return false;
  if (holds.size() < parsed.header.block_count) {
    for (const auto& hold : holds) hold.segment->release(hold.ref);
    ++counters_.lost;
    return true;
  }
  ++counters_.received;
  message = std::make_shared<const ReceivedMessage>(std::move(body), parsed, std::move(holds), link_);
  return true;
}

// Sequence numbers that never arrive were revoked before they were written.
bool Reader::advance(std::uint32_t sequence) {
  if (!is_after(sequence, last_sequence_)) return false;
  counters_.lost += sequence - last_sequence_ - 1;
  last_sequence_ = sequence;
  return true;
}

bool Reader::take(const ParsedBody& parsed, std::vector<ReceivedMessage::Hold>& holds) {
  holds.reserve(parsed.header.block_count);
  for (std::uint32_t i = 0; i < parsed.header.block_count; ++i) {
    const segment::BlockRef& ref = parsed.refs[i];
    const auto found = segments_.find(ref.segment);
    if (found == segments_.end() || !found->second->check(ref)) return broken("a block that does not exist");
    if (!found->second->take(ref)) break;
    posix::step("take: block taken");
    holds.push_back(ReceivedMessage::Hold{found->second, ref});
  }
  return true;
}

bool Reader::broken(const std::string& why) {
  reason_ = "the publisher broke the protocol: " + why;
  return false;
}

}  // namespace channel
}  // namespace tzc
