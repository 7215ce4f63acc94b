// SPDX-License-Identifier: BSD-3-Clause
#include "channel/subscribe/reader.h"

#include <algorithm>
#include <cstring>
#include <new>
#include <variant>

#include "channel/end_reason.h"
#include "channel/wire/age_stamp.h"
#include "channel/wire/delivery_cursors.h"
#include "channel/wire/recycled.h"
#include "channel/wire/wire.h"
#include "sync_point/sync_point.h"
#include "trace/trace.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::size_t in_message = ReceivedMessage::packet_bytes;
static_assert(slot_bytes <= in_message, "what comes through the ring lies in the message");

// What of a packet does not fit a message, until it is copied from here: one for each thread that reads, however many
// connections it reads from. Not initialised, so its pages are committed when such a packet arrives.
constexpr std::size_t overflow_bytes = max_packet_bytes - in_message;
std::uint8_t* overflow() {
  thread_local const std::unique_ptr<std::uint8_t[]> memory(new std::uint8_t[overflow_bytes]);
  return memory.get();
}

}  // namespace

Reader::Reader(std::shared_ptr<Link> link, const SubscriberOptions& options)
    : link_(std::move(link)),
      ring_(link_->ring()),
      last_sequence_(link_->first_sequence()),
      trace_(options, link_->page().trace_number()) {}

Reader::Result Reader::read(posix::Waiting waiting, MessagePtr& message) try {
  if (!reason_.empty()) return Result::closed;
  for (;;) {
    posix::ReceivedPacket packet;
    const auto result = receive(waiting, packet);
    if (result == posix::ReceiveResult::nothing) return Result::nothing;
    if (result == posix::ReceiveResult::closed) {
      reason_ = link_->sockets().missed() ? lent_socket_missed : closed_by_publisher;
      return Result::closed;
    }
    counters_.bytes += packet.size;
    if (trace::active) trace_.woken();
    if (!handle(packet, message)) return Result::closed;
    if (message) return Result::message;
  }
} catch (const std::bad_alloc&) {
  reason_ = "out of memory";  // this subscription ends, the process does not
  return Result::closed;
}

posix::ReceiveResult Reader::receive(posix::Waiting waiting, posix::ReceivedPacket& packet) {
  if (!next_) next_ = make_recycled<ReceivedMessage>(link_);
  for (;;) {
    const Source source = ring_.await(link_->ended(), waiting == posix::Waiting::block);
    if (source == Source::nothing) return posix::ReceiveResult::nothing;
    if (source == Source::ring) {
      packet.size = ring_.read(next_->packet());
      return posix::ReceiveResult::packet;
    }
    const posix::ReceiveResult result = receive_from_socket(waiting, packet);
    if (result != posix::ReceiveResult::closed || !link_->sockets().give_back()) return result;
    ring_.count_packet();
  }
}

// The end of a loan is not worth reading for: whoever may not read yet would be asked again and again.
bool Reader::has_something() {
  for (;;) {
    const Source source = ring_.await(link_->ended(), false);
    if (source != Source::socket) return source == Source::ring;
    const int socket = link_->sockets().current();
    if (socket < 0) return link_->ended();
    if (!posix::is_at_end(socket) || !link_->sockets().give_back()) return true;
    ring_.count_packet();
  }
}

// Asks for the end first: what was lent before the end is there by then.
posix::ReceiveResult Reader::receive_from_socket(posix::Waiting waiting, posix::ReceivedPacket& packet) {
  const bool ended = link_->ended();
  const int socket = link_->sockets().current();
  if (socket < 0) {
    sync_point("take: no socket");
    return ended ? posix::ReceiveResult::closed : posix::ReceiveResult::nothing;
  }
  const iovec parts[] = {{next_->packet(), in_message}, {overflow(), overflow_bytes}};
  const auto result = posix::receive_packet(socket, parts, 2, waiting, true, packet);
  if (result == posix::ReceiveResult::packet) ring_.count_packet();
  return result;
}

template <class Packet>
bool Reader::parse(std::size_t size, Packet& packet) const {
  static_assert(sizeof packet <= in_message, "overflow() never holds a part of it");
  if (size < sizeof packet) return false;
  std::memcpy(&packet, next_->packet(), sizeof packet);
  return true;
}

void Reader::append_packet(std::size_t from, std::size_t size, std::vector<std::uint8_t>& bytes) const {
  const std::uint8_t* first = next_->packet();
  bytes.insert(bytes.end(), first + from, first + std::min(size, in_message));
  if (size > in_message) bytes.insert(bytes.end(), overflow(), overflow() + (size - in_message));
}

bool Reader::handle(posix::ReceivedPacket& packet, MessagePtr& message) {
  PacketKind kind{};
  if (packet.truncated || !parse(packet.size, kind)) return broken("a packet of a wrong size");
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

const std::shared_ptr<segment::ReceivedSegment>* Reader::find_segment(std::uint64_t id) const {
  const auto found = std::find_if(segments_.begin(), segments_.end(),
                                  [id](const auto& segment) { return segment->id() == id; });
  return found == segments_.end() ? nullptr : &*found;
}

bool Reader::open_segment(posix::ReceivedPacket& packet) {
  SegmentPacket offer{};
  if (packet.size != sizeof offer || !parse(packet.size, offer)) return broken("a malformed segment");
  if (packet.descriptor_count != 2) {
    if (!packet.descriptors_lost) return broken("a segment without its files");
    give_up(segment_files_missed);
    return false;
  }
  if (segments_.size() >= max_segments || find_segment(offer.offer.id) != nullptr)
    return broken("too many segments");
  auto opened = segment::ReceivedSegment::open(offer.offer, std::move(packet.descriptors[0]),
                                               std::move(packet.descriptors[1]), link_->view_use().writes,
                                               &link_->write_notice());
  if (const auto* refusal = std::get_if<segment::Refusal>(&opened)) return broken(refusal->text());
  if (const auto* error = std::get_if<Error>(&opened)) {
    give_up("this process cannot map a segment of the publisher: " + error->text());
    return false;
  }
  segments_.push_back(std::get<std::shared_ptr<segment::ReceivedSegment>>(std::move(opened)));
  return true;
}

bool Reader::retire_segment(const posix::ReceivedPacket& packet) {
  RetireSegment retirement{};
  if (!parse(packet.size, retirement)) return broken("a malformed retirement");
  const auto* retired = find_segment(retirement.id);
  if (retired != nullptr) segments_.erase(segments_.begin() + (retired - segments_.data()));
  return true;
}

bool Reader::accept_record(const posix::ReceivedPacket& packet, MessagePtr& message) {
  RecordPrefix prefix{};
  if (!parse(packet.size, prefix)) return broken("a malformed record");
  const std::uint8_t* body = next_->packet() + sizeof prefix;
  if (packet.size > in_message) {
    std::vector<std::uint8_t> whole;
    append_packet(sizeof prefix, packet.size, whole);
    body = next_->adopt(std::move(whole));
  }
  return deliver(prefix.sequence, body, packet.size - sizeof prefix, message);
}

// Memory grows with what really arrived, never with what a peer merely announced.
bool Reader::accept_fragment(const posix::ReceivedPacket& packet, MessagePtr& message) {
  FragmentPrefix prefix{};
  if (!parse(packet.size, prefix)) return broken("a malformed fragment");
  const std::uint64_t slice = packet.size - sizeof prefix;
  if (prefix.offset == 0) {
    if (prefix.total > max_body_bytes) return broken("a message that is too large");
    assembly_ = Assembly{prefix.sequence, prefix.total, {}};
  }
  const bool fits = prefix.sequence == assembly_.sequence && prefix.total == assembly_.total &&
                    prefix.offset == assembly_.bytes.size() && slice > 0 &&
                    slice <= prefix.total - prefix.offset;
  if (!fits) return broken("fragments that don't fit together");
  append_packet(sizeof prefix, packet.size, assembly_.bytes);
  if (assembly_.bytes.size() < assembly_.total) return true;
  Assembly whole = std::move(assembly_);
  assembly_ = Assembly{};
  const std::size_t size = whole.bytes.size();
  return deliver(whole.sequence, next_->adopt(std::move(whole.bytes)), size, message);
}

// Only a subscriber that won the record may read its blocks: those of a revoked record may already be reused.
bool Reader::deliver(std::uint32_t sequence, const std::uint8_t* body, std::size_t size,
                     MessagePtr& message) {
  if (trace::active) trace_.taking();
  ParsedBody parsed;
  if (!advance(sequence) || !parse_body(body, size, parsed)) return broken("a malformed record");
  sync_point("take: before cursors");
  if (!try_take(link_->page().cursors(), sequence)) {
    ++counters_.lost;
    return true;
  }
  sync_point("take: record won");
  bool complete = false;
  if (!take_blocks(parsed, complete)) return false;
  if (!complete) {
    next_->release_blocks();
    ++counters_.lost;
    return true;
  }
  ++counters_.received;
  counters_.latencies.add(age_stamp() - parsed.header.made_at);
  next_->complete(parsed);
  if (trace::active) next_->traced_as(trace_.taken(sequence, size));
  message = std::move(next_);
  return true;
}

// Records whose sequence numbers never arrive were revoked before they were written.
bool Reader::advance(std::uint32_t sequence) {
  if (!is_after(sequence, last_sequence_)) return false;
  counters_.lost += sequence - last_sequence_ - 1;
  last_sequence_ = sequence;
  return true;
}

bool Reader::take_blocks(const ParsedBody& parsed, bool& complete) {
  for (std::uint32_t i = 0; i < parsed.header.block_count; ++i) {
    const segment::BlockRef& ref = parsed.refs[i];
    const auto* segment = find_segment(ref.segment);
    if (segment == nullptr || !(*segment)->check(ref)) return broken("a block that does not exist");
    if (!(*segment)->take(ref)) return true;
    sync_point("take: block taken");
    next_->hold(*segment, ref);
    counters_.shared_bytes += ref.size;
  }
  complete = true;
  return true;
}

bool Reader::broken(const std::string& why) {
  reason_ = "the publisher broke the protocol: " + why;
  return false;
}

}  // namespace channel
}  // namespace tzc
