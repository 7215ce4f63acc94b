// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

// What lies in a process's statistics page: a memory file that tzc-monitor finds in /proc/PID/fd by its name. The writer
// and readers of other builds must agree on it byte by byte: a change needs a new page_version, and
// tests/monitor/page_test.cpp says so when it is forgotten.
//
//   PageHeader | table 0 | table 1          each table: TableHeader | row | row | ...
//
// A row is a TopicRow, a ConnectionRow of the topic above it, or a SubscriptionRow. The tables take turns: the writer fills the one that is
// not published and then publishes its number, so a process that is stopped or killed while it writes leaves a whole
// table, and a reader never makes it wait. A reader that finds the same number before and after it has copied a table has
// a consistent copy.

namespace tzc {
namespace statistics {

constexpr std::uint64_t page_magic = 0x3173746174737a74;  // "tzstats1" in memory
constexpr std::uint32_t page_version = 2;
constexpr char page_name[] = "tzc-statistics";
constexpr std::uint32_t most_rows = 1024;  ///< of a table; what exceeds it is counted and left out
constexpr std::size_t row_bytes = 768;
constexpr std::size_t name_bytes = 256;  ///< of a text, with its terminating zero; a longer one is cut

struct PageHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t pid;         ///< of the writer, in its own namespace: a forked child has its parent's page
  std::uint64_t started_ns;  ///< CLOCK_MONOTONIC, when the page was made
  std::atomic<std::uint64_t>
      published;  ///< number of the newest whole table, which is table number % 2; 0: none yet
  char node[name_bytes];
};

struct TableHeader {
  std::uint64_t number;
  std::uint64_t updated_ns;  ///< CLOCK_MONOTONIC
  std::uint32_t rows;
  std::uint32_t left_out;  ///< rows for which there was no room
};

enum class RowKind : std::uint32_t { topic = 1, connection = 2, subscription = 3 };

/// Counts since the topic was advertised, as in tzc::PublisherStatistics.
struct TopicCounters {
  std::uint64_t messages, shared, serialized;
  std::uint64_t copied_bytes, control_bytes;
  std::uint64_t exhausted, dropped, revoked;
};

/// A publisher's memory now, as in tzc::MemoryStats: segments, bytes, and blocks in use.
struct TopicMemory {
  std::uint64_t segments, size, committed, used, blocks;
};

/// One publication of the process.
struct TopicRow {
  RowKind kind;
  std::uint32_t reserved;
  TopicCounters counters;
  TopicMemory memory;
  char topic[name_bytes];
  char type[name_bytes / 2];
};

enum class Transport : std::uint32_t { shared = 1, tcpros = 2, udpros = 3, intraprocess = 4 };

/// One subscriber of the publication above.
struct ConnectionRow {
  RowKind kind;
  Transport transport;
  std::uint64_t messages, bytes;  ///< sent, as roscpp counts them: of a shared message, its control part
  std::uint64_t in_flight;        ///< records sent and not taken yet
  std::uint64_t held;             ///< blocks taken and not released
  std::uint64_t revoked;          ///< records taken back before the subscriber took them
  std::uint64_t shared_bytes;     ///< of arrays that it was sent in shared memory
  /// What `revoked` is made of, by cause: its queue was full, best_effort needed the memory, it left.
  std::uint64_t revoked_for_queue, revoked_for_memory, revoked_at_end;
  std::uint64_t oldest_held_ms;  ///< for how long it has held the block that it has held longest
  std::uint32_t pid;             ///< of the subscriber, on shared memory; 0: not known
  std::uint32_t reserved;
  char subscriber[name_bytes];
  char reason[name_bytes];  ///< in words, why it is not on shared memory
};

constexpr std::size_t latency_buckets = 24;

/// One publisher of a topic that this process subscribes to.
struct SubscriptionRow {
  RowKind kind;
  Transport transport;
  std::uint64_t messages;       ///< received
  std::uint64_t lost;           ///< sent to this process and revoked before it took them
  std::uint64_t bytes;          ///< through the connection's socket and ring
  std::uint64_t shared_bytes;   ///< of arrays that were read in shared memory
  std::uint64_t held_messages;  ///< which this process keeps
  std::uint64_t held_bytes;     ///< of their arrays
  /// From publish to take: bucket i counts latencies below 2^i units of 1024 ns and not in one before it; the last one, all
  /// longer ones, too.
  std::uint64_t latencies[latency_buckets];
  std::uint32_t pid;  ///< of the publisher, on shared memory; 0: not known
  std::uint32_t reserved;
  char topic[name_bytes];
  char publisher[name_bytes];
};

constexpr std::size_t page_granule = 65536;  ///< the largest pages there are: no two parts share one
constexpr std::size_t table_bytes =
    (sizeof(TableHeader) + most_rows * row_bytes + page_granule - 1) / page_granule * page_granule;
constexpr std::size_t table_offset(std::uint64_t number) {
  return page_granule + (number % 2) * table_bytes;
}
constexpr std::size_t page_bytes = page_granule + 2 * table_bytes;

static_assert(sizeof(TopicRow) <= row_bytes && sizeof(ConnectionRow) <= row_bytes &&
                  sizeof(SubscriptionRow) <= row_bytes,
              "a row has its place");
static_assert(std::is_trivially_copyable<TopicRow>::value &&
                  std::is_trivially_copyable<ConnectionRow>::value &&
                  std::is_trivially_copyable<SubscriptionRow>::value,
              "rows are copied as bytes");
static_assert(ATOMIC_LLONG_LOCK_FREE == 2, "atomics shared by processes cannot lock");

}  // namespace statistics
}  // namespace tzc
