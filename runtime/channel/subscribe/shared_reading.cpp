// SPDX-License-Identifier: BSD-3-Clause
#include "tzc/shared_reading.h"

#include "channel/wait/receiver.h"

namespace tzc {
namespace channel {

bool read_while_idle(std::chrono::nanoseconds most, const std::function<bool()>& wanted) {
  Receiver* const receiver = Receiver::running();
  return receiver != nullptr && receiver->host(most, wanted);
}

void wake_idle_reader() {
  if (Receiver* const receiver = Receiver::running()) receiver->call_guest();
}

}  // namespace channel
}  // namespace tzc
