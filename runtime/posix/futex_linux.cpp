// SPDX-License-Identifier: BSD-3-Clause
#include <linux/futex.h>
#include <linux/types.h>
#include <sys/syscall.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>

#include "posix/futex.h"

namespace tzc {
namespace posix {

static_assert(sizeof(std::atomic<std::uint32_t>) == 4, "the kernel compares the word itself");

namespace {

/// A time as a system call reads it. The C library's timespec may be another one: 32-bit systems have calls of both kinds.
template <class Number>
struct KernelTime {
  explicit KernelTime(std::chrono::nanoseconds time)
      : seconds(static_cast<Number>(time.count() / 1000000000)),
        nanoseconds(static_cast<Number>(time.count() % 1000000000)) {}
  Number seconds;
  Number nanoseconds;
};

template <class Number>
long wait_until(long call, std::atomic<std::uint32_t>& word, std::uint32_t expected,
                std::chrono::nanoseconds end, std::uint32_t who) {
  const KernelTime<Number> timeout(end);
  return ::syscall(call, &word, FUTEX_WAIT_BITSET, expected, &timeout, nullptr, who);
}

}  // namespace

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
#ifdef SYS_futex_time64  // 32-bit systems, from Linux 5.1 on
  if (wait_until<std::int64_t>(SYS_futex_time64, word, expected, end, who) == 0 || errno != ENOSYS) return;
#endif
  wait_until<__kernel_long_t>(SYS_futex, word, expected, end, who);  // 32 bits count this clock for 68 years
}

void wake_sleeper(std::atomic<std::uint32_t>& word) {
  ::syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0);
}

void wake_sleeper(std::atomic<std::uint32_t>& word, std::uint32_t who) {
  ::syscall(SYS_futex, &word, FUTEX_WAKE_BITSET, 1, nullptr, nullptr, who);
}

}  // namespace posix
}  // namespace tzc
