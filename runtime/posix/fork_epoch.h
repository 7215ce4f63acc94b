// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <cstdint>

namespace tzc {
namespace posix {

/// Counts the forks between this process and the one that loaded the library. An object that remembers the
/// epoch of its creation knows with one load whether it is a forked copy, which must not touch what it shares
/// with its parent.
std::uint32_t fork_epoch() noexcept;

extern std::atomic<std::uint32_t> forks;  // fork_epoch() starts the count; only for forked_since

/// True in a process that was forked after `epoch` was read.
inline bool forked_since(std::uint32_t epoch) noexcept {
  return forks.load(std::memory_order_relaxed) != epoch;
}

}  // namespace posix
}  // namespace tzc
