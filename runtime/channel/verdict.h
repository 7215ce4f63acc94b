// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

// Who gets a record: the subscriber by taking it, or the publisher by revoking it. One word for each
// connection decides, so exactly one of them wins, for the whole record, however many blocks it has and how
// often they are sent.
//
//   | revoked through 32 | taken through 32 |      sequence numbers of records
//
// Records are sent and looked at in order. The subscriber takes record s by moving `taken` to s, unless s is
// already revoked; the publisher revokes everything up to s by moving `revoked` to s, unless s is already
// taken. Both are one compare-and-swap. Only the winner then changes the acknowledgement words of the
// record's blocks (segment/ack_word.h).
//
// Sequence numbers wrap around; at most 65535 records are undecided at a time, so "after" is well defined.

namespace tzc {
namespace channel {

struct Verdict {
  std::uint32_t revoked;
  std::uint32_t taken;
};

constexpr std::uint64_t pack(Verdict verdict) {
  return std::uint64_t{verdict.revoked} << 32 | verdict.taken;
}

constexpr Verdict unpack_verdict(std::uint64_t word) {
  return Verdict{static_cast<std::uint32_t>(word >> 32), static_cast<std::uint32_t>(word)};
}

constexpr bool is_after(std::uint32_t a, std::uint32_t b) {
  return static_cast<std::int32_t>(a - b) > 0;
}

/// An honest peer changes the word at most once for each undecided record.
constexpr int max_verdict_tries = 1 << 17;

/// The subscriber's move. False: the record is revoked, its blocks must not be touched.
template <class Atomic>
bool win_take(Atomic& word, std::uint32_t sequence) {
  std::uint64_t seen = word.load(std::memory_order_acquire);
  for (int i = 0; i < max_verdict_tries; ++i) {
    const Verdict verdict = unpack_verdict(seen);
    if (!is_after(sequence, verdict.revoked)) return false;
    const std::uint64_t next = pack(Verdict{verdict.revoked, sequence});
    if (word.compare_exchange_weak(seen, next, std::memory_order_acq_rel, std::memory_order_acquire))
      return true;
  }
  return false;
}

/// The publisher's move, for every record up to `sequence` that is not taken yet. False: that one is already
/// taken. `taken` tells where the subscriber was at that moment: records up to it are the subscriber's, those
/// after it and up to `sequence` are the publisher's.
template <class Atomic>
bool win_revoke(Atomic& word, std::uint32_t sequence, std::uint32_t& taken) {
  std::uint64_t seen = word.load(std::memory_order_acquire);
  for (int i = 0; i < max_verdict_tries; ++i) {
    const Verdict verdict = unpack_verdict(seen);
    taken = verdict.taken;
    if (!is_after(sequence, verdict.taken)) return false;
    const std::uint64_t next = pack(Verdict{sequence, verdict.taken});
    if (word.compare_exchange_weak(seen, next, std::memory_order_acq_rel, std::memory_order_acquire))
      return true;
  }
  return false;
}

}  // namespace channel
}  // namespace tzc
