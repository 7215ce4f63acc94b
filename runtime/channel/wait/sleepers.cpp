// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wait/sleepers.h"

#include "posix/futex.h"

namespace tzc {
namespace channel {

void Sleepers::sleep(Sleeper who, std::uint32_t heard, std::chrono::nanoseconds time,
                     const std::function<bool()>& wanted) {
  note(who, true);
  if (!wanted || !wanted()) posix::sleep_while(page_.bell, heard, time, who);
  note(who, false);
}

void Sleepers::wake(Sleeper who) {
  auto all = words();
  wake_if_asleep(all, who, [&] { posix::wake_sleeper(page_.bell, who); });
}

void Sleepers::note(Sleeper who, bool is_asleep) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto all = words();
  set_asleep(all, who, is_asleep);
}

}  // namespace channel
}  // namespace tzc
