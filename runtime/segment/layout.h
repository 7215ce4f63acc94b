// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>

// What lies in shared files. Both sides must agree on it byte by byte: a change needs a new layout_version,
// and tests/runtime/segment/layout_test.cpp says so when it is forgotten.
//
//   data file:   SegmentHeader | BlockHeader payload | BlockHeader payload | ...    written by the publisher
//   alone acknowledgement file (one for each connection and segment):
//                AckHeader | word of slot 0 | word of slot 1 | ...                  written by both sides

namespace tzc {
namespace segment {

constexpr std::uint32_t layout_version = 1;
constexpr std::uint64_t segment_magic = 0x31746e656d677a74;  // "tzgment1" in memory
constexpr std::uint32_t block_magic = 0x6b637a74;            // "tzck"
constexpr std::uint64_t ack_magic = 0x31736b63617a7a74;      // "tzzacks1"
constexpr std::size_t cache_line = 64;

/// First bytes of a data file; the first block header follows after segment_header_bytes.
struct SegmentHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t slots;  // most blocks at a time
  std::uint64_t id;     // unique among the segments of one publisher process
  std::uint64_t size;   // of the whole file
  char name[32];        // for people; terminated
};

/// In front of every payload.
struct BlockHeader {
  std::uint32_t magic;
  std::uint32_t generation;
  std::uint32_t slot;
  std::uint32_t reserved;
  std::uint64_t size;  // usable payload bytes
};

/// First bytes of an acknowledgement file.
struct AckHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t slots;
  std::atomic<std::uint32_t>
      releases;  // counts what the subscriber gave back: tells the publisher when to look
};

constexpr std::size_t segment_header_bytes = cache_line;
constexpr std::size_t block_header_bytes = cache_line;  // keeps the payload on a cache line of its own
constexpr std::size_t ack_header_bytes = cache_line;

constexpr std::size_t ack_file_bytes(std::uint32_t slots) {
  return ack_header_bytes + slots * sizeof(std::atomic<std::uint64_t>);
}

static_assert(sizeof(SegmentHeader) == segment_header_bytes, "the header fills its cache line");
static_assert(sizeof(BlockHeader) <= block_header_bytes, "the header fits in front of the payload");
static_assert(sizeof(AckHeader) <= ack_header_bytes, "the header fits in front of the words");
static_assert(sizeof(std::atomic<std::uint64_t>) == 8, "words are plain 64-bit memory");
static_assert(ATOMIC_LLONG_LOCK_FREE == 2 && ATOMIC_INT_LOCK_FREE == 2,
              "atomics shared by processes can't lock");

}  // namespace segment
}  // namespace tzc
