// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>

namespace tzc {

/// Longer than any healthy process takes to answer; a stopped one must not keep the others waiting for long.
constexpr std::chrono::milliseconds kCallTimeout(2000);

/// How long to wait after a try that was in vain, the first being number 1: doubled each time up to half a
/// minute, so that ten tries last one and a half minutes.
inline std::chrono::milliseconds pause_after(int tries) {
  constexpr std::chrono::milliseconds first(250), longest(32000);
  return std::min(longest, first * (1 << std::min(std::max(tries - 1, 0), 7)));
}

}  // namespace tzc
