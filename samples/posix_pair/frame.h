// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

/// The control part: small, copied. The pixels stay in shared memory.
struct Frame {
  std::uint64_t number;
  std::int64_t taken_ns;  // CLOCK_MONOTONIC
  std::uint32_t width, height;
};

constexpr char address[] = "@tzc-posix-pair";
