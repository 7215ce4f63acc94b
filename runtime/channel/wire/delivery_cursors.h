// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

// Decides who gets a record: the subscriber by taking it, or the publisher by revoking it. There is one word
// for each connection, so exactly one of them wins, for the whole record, however many blocks it has and
// however often they are sent.
//
//   | revoked through 32 | taken through 32 |      sequence numbers of records
//
// Records are sent and taken in order. The subscriber takes record s by moving `taken` to s, unless s is
// already revoked; the publisher revokes everything up to s by moving `revoked` to s, unless s is already
// taken. Both are one compare-and-swap. Only the winner then changes the block words of the record's blocks
// (segment/ack_word.h).
//
// Sequence numbers wrap around. "After" is well defined for numbers that are less than 2^31 apart: at most
// 65535 records are in flight at a time, and when one side has no reason to move its cursor, the other side
// moves it before it falls back that far (follow).

namespace tzc {
namespace channel {

struct DeliveryCursors {
  std::uint32_t revoked;
  std::uint32_t taken;
};

constexpr std::uint64_t pack(DeliveryCursors cursors) {
  return std::uint64_t{cursors.revoked} << 32 | cursors.taken;
}

constexpr DeliveryCursors unpack_cursors(std::uint64_t word) {
  return DeliveryCursors{static_cast<std::uint32_t>(word >> 32), static_cast<std::uint32_t>(word)};
}

constexpr bool is_after(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::int32_t>(a - b) > 0;
}

/// An honest peer changes the word at most once for each record in flight.
constexpr int max_cursor_tries = 1 << 17;

/// How far a cursor may fall behind the other one before the other side moves it.
constexpr std::uint32_t max_cursor_gap = std::uint32_t{1} << 30;

/// Moves a cursor that fell behind, after the other one has moved to `sequence`. All records up to there are
/// decided, so no decision changes.
constexpr std::uint32_t follow(std::uint32_t cursor, std::uint32_t sequence) {
  return sequence - cursor > max_cursor_gap ? sequence : cursor;
}

/// The subscriber's move. False: the record is revoked, its blocks must not be touched.
template <class Atomic>
bool try_take(Atomic& word, std::uint32_t sequence) {
  std::uint64_t seen = word.load(std::memory_order_acquire);
  for (int i = 0; i < max_cursor_tries; ++i) {
    const DeliveryCursors cursors = unpack_cursors(seen);
    if (!is_after(sequence, cursors.revoked)) return false;
    const std::uint64_t next = pack(DeliveryCursors{follow(cursors.revoked, sequence), sequence});
    if (word.compare_exchange_weak(seen, next, std::memory_order_acq_rel, std::memory_order_acquire))
      return true;
  }
  return false;
}

/// The publisher's move, for every record up to `sequence` that is not taken yet. False: that one is already
/// taken. `taken` tells where the subscriber was at that moment: records up to it are the subscriber's, those
/// after it and up to `sequence` are the publisher's.
template <class Atomic>
bool try_revoke(Atomic& word, std::uint32_t sequence, std::uint32_t& taken) {
  std::uint64_t seen = word.load(std::memory_order_acquire);
  for (int i = 0; i < max_cursor_tries; ++i) {
    const DeliveryCursors cursors = unpack_cursors(seen);
    taken = cursors.taken;
    if (!is_after(sequence, cursors.taken)) return false;
    const std::uint64_t next = pack(DeliveryCursors{sequence, follow(cursors.taken, sequence)});
    if (word.compare_exchange_weak(seen, next, std::memory_order_acq_rel, std::memory_order_acquire))
      return true;
  }
  return false;
}

}  // namespace channel
}  // namespace tzc
