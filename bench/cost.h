// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>

namespace tzc {
namespace bench {

/// Bytes that one process has moved through the calls that counted_calls.cpp counts. Lies in shared memory: the
/// process adds, another one reads.
struct Counts {
  std::atomic<std::uint64_t> sent;      // taken by send, sendto, sendmsg; what was received is counted
  std::atomic<std::uint64_t> received;  // given by recv, recvfrom, recvmsg
  std::atomic<std::uint64_t> copied;    // by memcpy and memmove, in calls of least_copy_bytes or more
  std::atomic<std::uint64_t>
      allocations;  // calls of malloc, calloc, realloc and their like: no bytes, how many
};

constexpr std::size_t least_copy_bytes = 1024;

/// From now on the calls of this process are added to counts; null: to nothing.
void count_into(Counts* counts);

/// What a process, or several together, spent on messages.
struct Cost {
  std::uint64_t sent_bytes = 0;
  std::uint64_t received_bytes = 0;
  std::uint64_t copied_bytes = 0;
  std::uint64_t page_faults = 0;  // the kernel's count: with and without reading a disk
  std::uint64_t allocations = 0;  // of heap memory
};

/// What the process has spent since it started.
Cost cost_of(pid_t process, const Counts& counts);
Cost operator-(const Cost& after, const Cost& before);
Cost& operator+=(Cost& sum, const Cost& more);

}  // namespace bench
}  // namespace tzc
