// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>

namespace tzc {
namespace posix {

/// Whether threads of different processes can wait for a word in shared memory here (Linux).
bool has_shared_futex();

/// Sleeps until wake_sleeper, unless `word` isn't `expected` any more. May return for no reason.
void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t expected);

/// The same, for so long at most. `who`: a bit by which wake_sleeper tells one sleeper from another.
void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t expected, std::chrono::nanoseconds time,
                 std::uint32_t who);

/// Wakes the thread that sleeps on `word`, in any process. Never blocks.
void wake_sleeper(std::atomic<std::uint32_t>& word);
/// The same for one of those bits.
void wake_sleeper(std::atomic<std::uint32_t>& word, std::uint32_t who);

}  // namespace posix
}  // namespace tzc
