// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "segment/received_segment.h"

// The packets that cross the socket, one structure for each kind; records may cross the ring instead
// (ring.h). Host byte order: both ends run on one machine. tests/runtime/channel/wire_test.cpp pins every
// size; a change needs a new wire_version.
//
//   subscriber                                publisher
//      | ---- Hello, hello text [+ doorbell] ---> |   authorize, on_connect
//      | <--- Welcome + connection page --------- |   or Refusal, reason
//      | <--- SegmentPacket + data, acks -------- |   before the first record that refers to the segment
//      | <--- RecordPrefix, body ---------------- |   or several FragmentPrefix, slice of the body
//      | ---- Unsubscribe ----------------------> |   the socket stays open while messages are held
//
//   body:  BodyHeader | BlockRef ... | control part
//
// Where two processes have a trunk (channel/connect/trunk.h), the Hello names it. Then the connection's socket is a loan:
// the publisher closes it when nothing crosses it, and lends another one over the trunk when something has to. Its end
// counts as a packet. What the ends have to say besides goes over the trunk, WordPackets.
//
//      | ---- Hello (is_trunk) -----------------> |
//      | <--- TrunkWelcome ---------------------- |   or Refusal, reason
//      | <--- lend + socket, end ---------------- |   for one of the connections that named the trunk
//      | ---- unsubscribe, gone ----------------> |

namespace tzc {
namespace channel {

constexpr std::uint32_t wire_version = 7;
constexpr std::uint32_t wire_magic = 0x315a4354;  // "TCZ1"
constexpr std::size_t fragment_bytes = 64 << 10;  // most bytes of a body in one packet
constexpr std::size_t max_hello_bytes = 32 << 10;
constexpr std::size_t max_refs = 4096 + 1;  // blocks of a record, and its control part's
// A fragmented record is assembled in memory.
constexpr std::uint64_t max_body_bytes = std::uint64_t{1} << 31;
constexpr std::size_t max_segments = 256;  // of one connection at a time

enum class PacketKind : std::uint32_t {
  hello = 1,
  welcome,
  refusal,
  segment,
  retire_segment,
  record,
  fragment,
  unsubscribe,
  trunk_welcome,
  word
};

/// What a subscriber asks for and a publisher agrees to.
enum Features : std::uint32_t {
  reads_ring = 1,  // usual records come through the ring (channel/wire/ring.h)
  has_doorbell =
      2,  // the ring's reader sleeps at a doorbell (channel/wait/doorbell.h), whose file comes with the hello
  takes_promptly =
      4,  // nothing runs between two messages: PublisherOptions::buffered_bytes is for such subscribers
  is_trunk = 8,   // no connection: the socket is to be a trunk
  has_trunk = 16  // the connection's socket is a loan
};

struct Hello {
  PacketKind kind;
  std::uint32_t magic;
  std::uint32_t version;
  std::uint32_t hello_bytes;
  std::uint32_t features = 0;
  std::uint32_t doorbell_bytes = 0;   // of its file
  std::uint32_t doorbell_number = 0;  // of this connection's bit there
  std::uint32_t trunk_number = 0;     // of this connection there; is_trunk: so many loans are taken at a time
  std::uint64_t publication = 0;      // which publisher behind the socket; 0: the only one
  std::uint64_t trunk = 0;            // TrunkWelcome::id
};

struct Welcome {
  PacketKind kind;
  std::uint32_t version;
  std::uint32_t first_sequence;  // of the first record, minus one
  std::uint32_t page_bytes;
  std::uint32_t features;
};

/// Followed by the reason, text.
struct Refusal {
  PacketKind kind;
  std::uint32_t version;
};

struct TrunkWelcome {
  PacketKind kind;
  std::uint32_t version;
  std::uint64_t id;  // cannot be guessed
};

/// What is said over a trunk, of one of its connections.
enum class TrunkWord : std::uint32_t {
  lend = 1,     // publisher: its next packets come through this socket
  end,          // publisher: nothing more comes
  unsubscribe,  // subscriber: send nothing more
  gone          // subscriber: it holds nothing any more
};

struct WordPacket {
  PacketKind kind;
  TrunkWord word;
  std::uint32_t number;  // of the connection
};

struct SegmentPacket {
  PacketKind kind;
  std::uint32_t reserved;
  segment::SegmentOffer offer;
};

struct RetireSegment {
  PacketKind kind;
  std::uint32_t reserved;
  std::uint64_t id;
};

struct RecordPrefix {
  PacketKind kind;
  std::uint32_t sequence;
};

struct FragmentPrefix {
  PacketKind kind;
  std::uint32_t sequence;
  std::uint64_t offset;  // of this slice in the body
  std::uint64_t total;   // bytes of the body
};

struct Unsubscribe {
  PacketKind kind;
};

enum BodyFlags : std::uint32_t { control_in_last_block = 1 };

struct BodyHeader {
  std::uint32_t tag;
  std::uint32_t flags;
  std::uint32_t block_count;
  std::uint32_t made_at;  // age_stamp(), for the subscriber's latencies
  std::uint64_t control_size;
};

constexpr std::size_t max_packet_bytes = sizeof(FragmentPrefix) + fragment_bytes;

static_assert(max_hello_bytes + sizeof(Hello) <= max_packet_bytes, "a Hello fits in one packet");

}  // namespace channel
}  // namespace tzc
