// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>

#include "channel/doorbell.h"
#include "posix/hot.h"

namespace tzc {
namespace channel {

/// The threads of this process that sleep at its doorbell. A publisher wakes one of them: the guest, if it sleeps.
///
/// Each tells publishers that it is awake, and then looks for records: those of which it was told meanwhile, and those of
/// which the other one will not be told, are there by then. Thread-safe.
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
  void set_asleep(Sleeper who, bool asleep);

  DoorbellPage& page_;
  std::mutex mutex_;
  std::atomic<std::uint32_t> asleep_{0};  // Sleepers. Not in the page, to which others may write
};

}  // namespace channel
}  // namespace tzc
