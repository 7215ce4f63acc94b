// SPDX-License-Identifier: BSD-3-Clause
#include "posix/fork_epoch.h"

#include <pthread.h>

namespace tzc {
namespace posix {

std::atomic<std::uint32_t> forks{0};

namespace {

void count_fork() {
  forks.fetch_add(1, std::memory_order_relaxed);
}

bool watch_forks() {
  return ::pthread_atfork(nullptr, nullptr, count_fork) == 0;
}

}  // namespace

std::uint32_t fork_epoch() noexcept {
  static const bool watched = watch_forks();
  (void)watched;
  return forks.load(std::memory_order_relaxed);
}

}  // namespace posix
}  // namespace tzc
