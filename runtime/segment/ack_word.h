// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

// The acknowledgement word of one block for one subscriber:
//
//   | generation 32 | in flight 16 | taken 16 |
//
//   publisher: mark    in flight + 1    before the record is sent
//              revoke  in flight - 1    after it won the record (channel/wire/delivery_cursors.h)
//   subscriber: take   in flight - 1, taken + 1    after it won the record
//               release taken - 1
//               take_again  taken + 1, for a forked child, where it is not 0
//
// Every step is one compare-and-swap that also compares the generation, so no step can ever hit another block
// that reuses the slot. The block is free for this subscriber when both counts are 0. A word of another
// generation is stale: the next mark overwrites it. Counters never wrap: a step that would do so fails
// instead. The generation does wrap, from the largest to 1; 0 is never used.
//
// Templated on the atomic type so that the model checker runs this very code.

namespace tzc {
namespace segment {

struct AckCounts {
  std::uint32_t generation;
  std::uint32_t in_flight;
  std::uint32_t taken;
};

constexpr std::uint32_t max_ack_count = 0xffff;

constexpr std::uint64_t pack(AckCounts counts) {
  return std::uint64_t{counts.generation} << 32 | std::uint64_t{counts.in_flight} << 16 | counts.taken;
}

constexpr AckCounts unpack(std::uint64_t word) {
  return AckCounts{static_cast<std::uint32_t>(word >> 32),
                   static_cast<std::uint32_t>(word >> 16 & max_ack_count),
                   static_cast<std::uint32_t>(word & max_ack_count)};
}

constexpr std::uint32_t next_generation(std::uint32_t generation) {
  return generation == 0xffffffff ? 1 : generation + 1;
}

/// An honest peer changes a word at most once per reference; one that keeps changing it must not keep us
/// here.
constexpr int max_ack_tries = 1 << 17;

/// Replaces the word by step(word) until it sticks; `step` returns false to give up. False: gave up, or the
/// peer keeps changing the word.
template <class Atomic, class Step>
bool update_ack(Atomic& word, Step step) {
  std::uint64_t seen = word.load(std::memory_order_acquire);
  for (int i = 0; i < max_ack_tries; ++i) {
    AckCounts counts = unpack(seen);
    if (!step(counts)) return false;
    if (word.compare_exchange_weak(seen, pack(counts), std::memory_order_acq_rel, std::memory_order_acquire))
      return true;
  }
  return false;
}

template <class Atomic>
bool mark_in_flight(Atomic& word, std::uint32_t generation) {
  return update_ack(word, [generation](AckCounts& counts) {
    if (counts.generation != generation) counts = AckCounts{generation, 0, 0};
    return counts.in_flight++ < max_ack_count;
  });
}

template <class Atomic>
bool revoke_in_flight(Atomic& word, std::uint32_t generation) {
  return update_ack(word, [generation](AckCounts& counts) {
    return counts.generation == generation && counts.in_flight-- > 0;
  });
}

template <class Atomic>
bool take(Atomic& word, std::uint32_t generation) {
  return update_ack(word, [generation](AckCounts& counts) {
    return counts.generation == generation && counts.in_flight-- > 0 && counts.taken++ < max_ack_count;
  });
}

/// For a process that has taken the block already.
template <class Atomic>
bool take_again(Atomic& word) {
  return update_ack(word,
                    [](AckCounts& counts) { return counts.taken > 0 && counts.taken++ < max_ack_count; });
}

template <class Atomic>
bool release(Atomic& word, std::uint32_t generation) {
  return update_ack(word, [generation](AckCounts& counts) {
    return counts.generation == generation && counts.taken-- > 0;
  });
}

/// The subscriber behind this word does not reference the block of that generation.
inline bool is_idle(std::uint64_t word, std::uint32_t generation) {
  const AckCounts counts = unpack(word);
  return counts.generation != generation || (counts.in_flight == 0 && counts.taken == 0);
}

/// The publisher's own note of what it marked: a peer can write to the word, and not to this. Relaxed: who asks may_hold
/// about a generation has synchronised with the sender, through the last BufferPtr.
template <class Note, class Atomic>
bool note_and_mark(Note& note, Atomic& word, std::uint32_t generation) {
  note.store(generation, std::memory_order_relaxed);
  return mark_in_flight(word, generation);
}

template <class Note, class Atomic>
bool may_hold(const Note& note, const Atomic& word, std::uint32_t generation) {
  if (note.load(std::memory_order_relaxed) != generation) return false;
  return !is_idle(word.load(std::memory_order_acquire), generation);
}

}  // namespace segment
}  // namespace tzc
