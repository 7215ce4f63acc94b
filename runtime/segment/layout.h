// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

#include "segment/release_hints.h"

// What lies in shared files. Both sides must agree on it byte by byte: a change needs a new layout_version,
// and tests/runtime/segment/layout_test.cpp says so when it is forgotten.
//
//   segment:     SegmentHeader | BlockHeader of slot 0 | of slot 1 | ... | page boundary | payloads
//                a memory file, or a part of one; written by the publisher alone
//   ack file:    AckHeader | leaves of the release hints | word of slot 0 | word of slot 1 | ...
//                one for each connection and segment, written by both sides

namespace tzc {
namespace segment {

constexpr std::uint32_t layout_version = 2;
constexpr std::uint64_t segment_magic = 0x31746e656d677a74;  // "tzgment1" in memory
constexpr std::uint32_t block_magic = 0x6b637a74;            // "tzck"
constexpr std::uint64_t ack_magic = 0x31736b63617a7a74;      // "tzzacks1"
constexpr std::size_t cache_line = 64;

// A payload of a page or more begins on a page and shares none. A subscriber's process may make those pages its own when
// it writes there, so everything else is read through other pages.

/// First bytes of a segment.
struct SegmentHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t slots;  // most blocks at a time
  std::uint64_t id;     // unique among the segments of one publisher process
  std::uint64_t size;   // of the whole segment
  char name[32];        // for people; terminated
};

/// One for each slot. The subscriber compares it with the reference that it received.
struct BlockHeader {
  std::uint32_t magic;
  std::uint32_t generation;
  std::uint32_t slot;
  std::uint32_t reserved;
  std::uint64_t offset;  // of the payload in the segment
  std::uint64_t size;    // usable payload bytes
};

/// First bytes of an ack file.
struct AckHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t slots;
  // Groups of slots that the subscriber released something of (release_hints.h).
  std::atomic<std::uint64_t> released;
};

constexpr std::size_t segment_header_bytes = cache_line;
constexpr std::size_t block_header_bytes = cache_line;  // headers don't share cache lines
constexpr std::size_t ack_header_bytes = cache_line;

constexpr std::size_t block_header_offset(std::uint32_t slot) {
  return segment_header_bytes + slot * block_header_bytes;
}
/// Where payloads begin. `page`: bytes of the system's pages.
constexpr std::size_t payloads_offset(std::uint32_t slots, std::size_t page) {
  return (block_header_offset(slots) + page - 1) / page * page;
}

/// Where the words begin in an ack file: after the leaves, on a cache line of their own.
constexpr std::size_t ack_words_offset(std::uint32_t slots) {
  return ack_header_bytes +
         (hint_leaves(slots) * sizeof(std::uint64_t) + cache_line - 1) / cache_line * cache_line;
}

constexpr std::size_t ack_file_bytes(std::uint32_t slots) {
  return ack_words_offset(slots) + slots * sizeof(std::atomic<std::uint64_t>);
}

static_assert(sizeof(SegmentHeader) == segment_header_bytes, "the header fills its cache line");
static_assert(sizeof(BlockHeader) <= block_header_bytes, "a header fits its cache line");
static_assert(sizeof(AckHeader) <= ack_header_bytes, "the header fits in front of the words");
static_assert(sizeof(std::atomic<std::uint64_t>) == 8, "words are plain 64-bit memory");
static_assert(ATOMIC_LLONG_LOCK_FREE == 2 && ATOMIC_INT_LOCK_FREE == 2,
              "atomics shared by processes cannot lock");

}  // namespace segment
}  // namespace tzc
