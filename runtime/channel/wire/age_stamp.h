// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <cstdint>

namespace tzc {
namespace channel {

/// When a record was made, in the 32 bits that its header has for it: CLOCK_MONOTONIC, which the processes of a machine
/// share, in units of 1024 ns. An age is right up to 73 minutes, and then begins at 0 again.
inline std::uint32_t age_stamp() noexcept {
  const auto since_boot = std::chrono::steady_clock::now().time_since_epoch();
  return static_cast<std::uint32_t>(
      static_cast<std::uint64_t>(std::chrono::nanoseconds(since_boot).count()) >> 10);
}

}  // namespace channel
}  // namespace tzc
