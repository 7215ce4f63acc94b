// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

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
// The bell, a futex, changes with each record and packet that is written. One side writes each word; only the
// bell is also rung by the subscriber itself, when its connection ends. Neither side trusts what the other
// writes: the publisher's words can make the subscriber read garbage, as its packets can, and the
// subscriber's words can make it lose its own records.

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

/// Either this call sees the sleeper, or the sleeper sees the bell before it falls asleep. The `sleeping`
/// word may be set without need, but never missing while the subscriber sleeps.
template <class Words, class Wake>
TZC_HOT void ring_bell(Words& words, Wake wake) {
  words.bell.fetch_add(1, std::memory_order_seq_cst);
  if (words.sleeping.load(std::memory_order_seq_cst) != 0) wake();
}

enum class Source { ring, socket, nothing };

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

/// Subscriber: sleeps unless the bell has rung since it was `heard`. `sleep` does so for as long as the word
/// is that value.
template <class Words, class Sleep>
TZC_HOT void wait_for_bell(Words& words, std::uint32_t heard, Sleep sleep) {
  words.sleeping.store(1, std::memory_order_seq_cst);
  sleep(heard);
  words.sleeping.store(0, std::memory_order_relaxed);
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

/// The publisher's end. Used by one thread at a time.
class RingWriter {
 public:
  /// Null: the subscriber reads only its socket, so everything goes there.
  explicit RingWriter(Ring* ring) : ring_(ring) {}

  /// Puts a packet of two parts into the ring. False: it has to go through the socket.
  TZC_HOT bool write(const void* prefix, std::size_t prefix_size, const void* body, std::size_t body_size);
  /// So many packets went through the socket until now.
  void sent_packets(std::uint32_t count);

 private:
  Ring* ring_;
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

/// Makes a reader look again, for example because its connection has ended.
void wake_reader(Ring& ring);

}  // namespace channel
}  // namespace tzc
