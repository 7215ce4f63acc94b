// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "posix/mapping.h"
#include "posix/memory_file.h"
#include "tzc/error.h"

namespace tzc {
namespace posix {

/// Memory that this process shares with its peers: the file, and the mapping that this process writes through.
struct SharedMemory {
  MemoryFile file;
  Mapping mapping;
};

/// Creates a memory file of `size` bytes, a multiple of the page size, commits the first `committed` bytes of it, maps it,
/// and seals it as `sharing` says. Errors are those of these steps (memory_file.h); nothing is left of a failed one.
/// Thread-safe.
Expected<SharedMemory> create_shared_memory(const char* name, std::size_t size, std::size_t committed,
                                            Sharing sharing);

}  // namespace posix
}  // namespace tzc
