// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace tzc {

/// The most bytes that TZC's memory files of this process may take in all: segments, and the pages beside them;
/// SIZE_MAX, the default: no limit. What is taken already stays; an allocate that needs more pages is refused, and its
/// Error says so. Thread-safe.
void set_memory_ceiling(std::size_t bytes);

/// What they take now, and the most that they may.
struct ProcessMemory {
  std::size_t reserved_bytes;
  std::size_t ceiling;
};
/// Thread-safe.
ProcessMemory process_memory();

}  // namespace tzc
