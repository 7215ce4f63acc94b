// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>

#include "channel/wait/doorbell.h"
#include "posix/hot.h"

namespace tzc {
namespace channel {

/// The words of Sleepers: Atomic is a reference to one, or a model's (tests/model/sleepers_model.cpp).
template <class Atomic>
struct SleeperWords {
  Atomic bell;
  Atomic sleeping;  // whom a publisher wakes
  Atomic asleep;    // all of them: Sleeper
};

/// Not thread-safe: the caller holds the lock.
template <class Words>
void set_asleep(Words& words, Sleeper who, bool is_asleep) {
  const std::uint32_t before = static_cast<std::uint32_t>(words.asleep.load(std::memory_order_relaxed));
  const std::uint32_t now = is_asleep ? before | who : before & ~static_cast<std::uint32_t>(who);
  words.asleep.store(now, std::memory_order_seq_cst);
  const std::uint32_t woken = (now & guest_sleeps) != 0 ? std::uint32_t{guest_sleeps} : now;
  words.sleeping.store(woken, std::memory_order_seq_cst);
}

/// Wakes the sleeper, and changes the bell, since the sleeper may be about to fall asleep.
template <class Words, class Wake>
void wake_if_asleep(Words& words, Sleeper who, Wake wake) {
  if ((words.asleep.load(std::memory_order_seq_cst) & who) == 0) return;
  words.bell.fetch_add(1, std::memory_order_seq_cst);
  wake();
}

/// The threads of this process that sleep at its doorbell. A publisher wakes one of them: the guest, if it sleeps.
///
/// Each first clears its bit in `asleep` and then looks for records: it finds those that were written before, and one that is written
/// later rings the bell. Thread-safe.
class Sleepers {
 public:
  explicit Sleepers(Doorbell& doorbell) : page_(doorbell.page()) {}

  /// Sleeps unless the bell has rung since it was `heard`, for so long at most, and not at all if `wanted` (may be null)
  /// says that there is other work. May return for no reason.
  TZC_HOT void sleep(Sleeper who, std::uint32_t heard, std::chrono::nanoseconds time,
                     const std::function<bool()>& wanted);
  /// Whoever makes work for a sleeper calls this afterwards: either `wanted` sees the work, or this sees the sleeper.
  void wake(Sleeper who);

 private:
  void note(Sleeper who, bool is_asleep);
  SleeperWords<std::atomic<std::uint32_t>&> words() { return {page_.bell, page_.sleeping, asleep_}; }

  DoorbellPage& page_;
  std::mutex mutex_;
  std::atomic<std::uint32_t> asleep_{0};  // Sleepers. Not in the page, to which others may write
};

}  // namespace channel
}  // namespace tzc
