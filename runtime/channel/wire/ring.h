// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "channel/wait/doorbell.h"
#include "posix/hot.h"

// A usual record reaches a subscriber's reader thread through a ring in the page that both ends map, and a
// futex. This wakes the thread at two thirds of the cost of a socket (decision 107).
//
// Everything else crosses the socket: descriptors, records that are larger than a slot, and records for which
// the ring is full. Ring and socket together keep the order, because
//
//   - the publisher writes into the ring only when the subscriber has read every packet of the socket, and
//   - the subscriber reads a packet only when it has emptied the ring, as it is after it learned of the packet.
//
// The end of a socket that was lent (channel/connect/trunk.h) is a packet, too: what crosses the next one comes after it.
//
// The bell, a futex, changes with each record and packet that is written (channel/wait/bell.h); a thread that reads
// many rings has one bell for all of them (channel/wait/doorbell.h). One side writes each word; only the bell is also
// rung by the subscriber itself, when its connection ends. Neither side trusts what the other writes: the publisher's
// words can make the subscriber read garbage, as its packets can, and the subscriber's words can make it lose its own
// records.

namespace tzc {
namespace channel {

constexpr std::uint32_t ring_slots = 8;
constexpr std::size_t slot_bytes = 476;
// Of all counts: every run goes through the wrap (decision 105).
constexpr std::uint32_t ring_start = 0xffffffff - 5;

/// The words of a ring: Atomic is a reference to one, or a model's (tests/model).
template <class Atomic>
struct RingWords {
  Atomic bell;          // anything was written
  Atomic written;       // records in the ring
  Atomic packets;       // packets in the socket
  Atomic sleeping;      // the subscriber waits for the bell
  Atomic read;          // records out of the ring
  Atomic packets_read;  // packets out of the socket
};

/// Publisher: may the next record go into a ring of so many slots, after so many records and packets?
template <class Words>
TZC_HOT bool ring_takes(Words& words, std::uint32_t slots, std::uint32_t written, std::uint32_t packets) {
  return words.packets_read.load(std::memory_order_acquire) == packets &&
         written - words.read.load(std::memory_order_acquire) < slots;
}

/// Publisher: the slot's record may be read, the socket's packets are there. Each count includes the latest one.
template <class Words>
TZC_HOT void announce_record(Words& words, std::uint32_t written) {
  words.written.store(written, std::memory_order_release);
}
template <class Words>
void announce_packets(Words& words, std::uint32_t packets) {
  words.packets.store(packets, std::memory_order_release);
}

/// Subscriber: the slot was copied and may be written again, a packet came out of the socket.
template <class Words>
TZC_HOT void give_back_slot(Words& words, std::uint32_t read) {
  words.read.store(read, std::memory_order_release);
}
template <class Words>
void acknowledge_packet(Words& words, std::uint32_t packets_read) {
  words.packets_read.store(packets_read, std::memory_order_release);
}

enum class Source { ring, socket, nothing };

/// Subscriber: the bell, before it looks for anything.
template <class Words>
TZC_HOT std::uint32_t listen(Words& words) {
  return static_cast<std::uint32_t>(words.bell.load(std::memory_order_acquire));
}

/// Subscriber: where the next thing to read is, after so many records and packets. `written` tells how far
/// the ring goes. The packets are counted first: whatever precedes them in the ring is seen then, too.
template <class Words>
TZC_HOT Source next_source(Words& words, std::uint32_t read, std::uint32_t packets_read, bool ended,
                           std::uint32_t& written) {
  const bool in_socket = words.packets.load(std::memory_order_acquire) != packets_read || ended;
  written = words.written.load(std::memory_order_acquire);
  if (written != read) return Source::ring;
  return in_socket ? Source::socket : Source::nothing;
}

/// Its memory.
struct Ring {
  struct Slot {
    std::atomic<std::uint32_t> size;
    std::uint8_t bytes[slot_bytes];
  };

  struct PublishersWords {
    std::atomic<std::uint32_t> bell, written, packets;
  };
  struct SubscribersWords {
    std::atomic<std::uint32_t> sleeping, read, packets_read;
  };

  alignas(64) PublishersWords publisher{{0}, {ring_start}, {ring_start}};
  alignas(64) SubscribersWords subscriber{{0}, {ring_start}, {ring_start}};
  alignas(64) Slot slots[ring_slots];
};

/// Where the reader of a ring is called: at a doorbell, or, without one, at the ring's own bell.
struct BellPull {
  std::shared_ptr<Doorbell> doorbell{};
  std::uint32_t number = 0;

  TZC_HOT void pull(Ring& ring) const;
};

/// The publisher's end. Used by one thread at a time.
class RingWriter {
 public:
  /// Null: the subscriber reads only its socket, so everything goes there.
  /// `bell`: where its reader is called.
  explicit RingWriter(Ring* ring, BellPull bell = {}) : ring_(ring), bell_(std::move(bell)) {}

  /// Puts a packet of two parts into the ring. False: it has to go through the socket.
  TZC_HOT bool write(const void* prefix, std::size_t prefix_size, const void* body, std::size_t body_size);
  /// So many packets went through the socket until now.
  void sent_packets(std::uint32_t count);
  /// Whether the subscriber has read all of them. Without a ring nobody knows.
  bool all_packets_read() const;

 private:
  Ring* ring_;
  const BellPull bell_;
  std::uint32_t written_ = ring_start;
  std::uint32_t packets_ = ring_start;
};

/// The subscriber's end. Used by one thread at a time.
class RingReader {
 public:
  /// Null: there is none.
  explicit RingReader(Ring* ring) : ring_(ring) {}

  /// Where the next record or packet is; without a ring: in the socket. `wait`: sleeps until there is one.
  TZC_HOT Source await(const std::atomic<bool>& ended, bool wait);
  /// Source::ring: copies the next packet to `memory`, which has slot_bytes. 0: the ring is broken.
  TZC_HOT std::size_t read(void* memory);
  /// Source::socket: a packet came out of it.
  void count_packet();

 private:
  Ring* ring_;
  std::uint32_t read_ = ring_start;
  std::uint32_t written_ = ring_start;
  std::uint32_t packets_read_ = ring_start;
};

/// Makes a reader that sleeps at the ring's own bell look again, for example because its connection has ended.
void wake_reader(Ring& ring);

}  // namespace channel
}  // namespace tzc
