// SPDX-License-Identifier: BSD-3-Clause
#include "posix/futex.h"

namespace tzc {
namespace posix {

bool has_shared_futex() {
  return false;
}

void sleep_while(std::atomic<std::uint32_t>&, std::uint32_t) {}

void sleep_while(std::atomic<std::uint32_t>&, std::uint32_t, std::chrono::nanoseconds, std::uint32_t) {}

void wake_sleeper(std::atomic<std::uint32_t>&) {}

void wake_sleeper(std::atomic<std::uint32_t>&, std::uint32_t) {}

}  // namespace posix
}  // namespace tzc
