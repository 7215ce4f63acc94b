// SPDX-License-Identifier: BSD-3-Clause
#include "channel/sleepers.h"

#include "posix/futex.h"

namespace tzc {
namespace channel {

void Sleepers::sleep(Sleeper who, std::uint32_t heard, std::chrono::nanoseconds time,
                     const std::function<bool()>& wanted) {
  set_asleep(who, true);
  if (!wanted || !wanted()) posix::sleep_while(page_.bell, heard, time, who);
  set_asleep(who, false);
}

void Sleepers::wake(Sleeper who) {
  if ((asleep_.load(std::memory_order_seq_cst) & who) == 0) return;
  page_.bell.fetch_add(1, std::memory_order_seq_cst);
  posix::wake_sleeper(page_.bell, who);
}

void Sleepers::set_asleep(Sleeper who, bool asleep) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::uint32_t now = asleep ? asleep_ | who : asleep_ & ~static_cast<std::uint32_t>(who);
  asleep_.store(now, std::memory_order_seq_cst);
  const std::uint32_t woken = (now & guest_sleeps) != 0 ? guest_sleeps : now;
  page_.sleeping.store(woken, std::memory_order_seq_cst);
}

}  // namespace channel
}  // namespace tzc
