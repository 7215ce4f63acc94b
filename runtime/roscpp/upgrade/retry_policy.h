// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <chrono>

namespace tzc {
namespace detail {

/// Longer than a healthy process takes to answer, but short: a stopped one must not delay the others for
/// long.
constexpr std::chrono::milliseconds kCallTimeout(2000);

/// The pause after failed attempt number `attempts` (from 1): doubled each time, at most half a minute up to the
/// tenth, so that ten attempts last one and a half minutes; then five minutes.
inline std::chrono::milliseconds pause_after(int attempts) {
  constexpr std::chrono::milliseconds first(250), longest(32000);
  constexpr std::chrono::minutes seldom(5);
  if (attempts > 10) return seldom;
  return std::min(longest, first * (1 << std::min(std::max(attempts - 1, 0), 7)));
}

}  // namespace detail
}  // namespace tzc
