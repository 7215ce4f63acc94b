// SPDX-License-Identifier: BSD-3-Clause
#include <linux/futex.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include "posix/futex.h"

namespace tzc {
namespace posix {

static_assert(sizeof(std::atomic<std::uint32_t>) == 4, "the kernel compares the word itself");

bool has_shared_futex() {
  return true;
}

void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t expected) {
  ::syscall(SYS_futex, &word, FUTEX_WAIT, expected, nullptr, nullptr, 0);
}

void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t expected, std::chrono::nanoseconds time,
                 std::uint32_t who) {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);  // this operation wants the time of its end
  const std::chrono::nanoseconds end =
      std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec) + time;
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(end);
  const timespec timeout{static_cast<time_t>(seconds.count()), static_cast<long>((end - seconds).count())};
  ::syscall(SYS_futex, &word, FUTEX_WAIT_BITSET, expected, &timeout, nullptr, who);
}

void wake_sleeper(std::atomic<std::uint32_t>& word) {
  ::syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

void wake_sleeper(std::atomic<std::uint32_t>& word, std::uint32_t who) {
  ::syscall(SYS_futex, &word, FUTEX_WAKE_BITSET, 1, nullptr, nullptr, who);
}

}  // namespace posix
}  // namespace tzc
