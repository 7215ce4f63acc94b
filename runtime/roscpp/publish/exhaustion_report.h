// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/memory.h>
#include <tzc/options.h>

#include <cstdint>
#include <string>

namespace tzc {
namespace detail {

/// A message that found no shared memory.
struct Exhaustion {
  std::string topic;
  std::size_t message_bytes;
  OnExhausted outcome;    ///< what happened to it
  std::uint64_t so_far;   ///< messages of this topic to which that happened
  std::string in_flight;  ///< subscribers with messages in flight; may be empty
};

/// A text for users: what happened, why, which subscribers use the memory, and which parameter to set. `failure`: of the
/// allocate that was refused.
std::string exhaustion_report(const Exhaustion& what, const MemoryOptions& options, const MemoryStats& memory,
                              const AllocationError& failure);

}  // namespace detail
}  // namespace tzc
