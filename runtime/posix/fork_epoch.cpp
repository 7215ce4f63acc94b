// SPDX-License-Identifier: BSD-3-Clause
#include "posix/fork_epoch.h"

#include <pthread.h>

#include <atomic>

namespace tzc {
namespace posix {
namespace {

std::atomic<std::uint32_t> epoch{0};

void count_fork() {
  epoch.fetch_add(1, std::memory_order_relaxed);
}

bool watch_forks() {
  return ::pthread_atfork(nullptr, nullptr, count_fork) == 0;
}

}  // namespace

std::uint32_t fork_epoch() noexcept {
  static const bool watched = watch_forks();
  (void)watched;
  return epoch.load(std::memory_order_relaxed);
}

}  // namespace posix
}  // namespace tzc
