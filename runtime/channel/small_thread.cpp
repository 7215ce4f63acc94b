// SPDX-License-Identifier: BSD-3-Clause
#include "channel/small_thread.h"

#include <utility>

#include "posix/thread.h"

namespace tzc {
namespace channel {

Status start_small_thread(const char* name, std::function<void()> body) {
  return posix::start_small_thread(name, std::move(body));
}

}  // namespace channel
}  // namespace tzc
