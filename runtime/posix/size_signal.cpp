// SPDX-License-Identifier: BSD-3-Clause
#include "posix/size_signal.h"

#include <cerrno>
#include <ctime>

namespace tzc {
namespace posix {
namespace {

sigset_t size_signal() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGXFSZ);
  return set;
}

bool is_pending() {
  sigset_t pending;
  sigemptyset(&pending);
  ::sigpending(&pending);
  return sigismember(&pending, SIGXFSZ) == 1;
}

}  // namespace

SizeSignalBlocked::SizeSignalBlocked() noexcept : was_pending_(is_pending()) {
  const sigset_t set = size_signal();
  ::pthread_sigmask(SIG_BLOCK, &set, &before_);
}

// The kernel sends it to the thread that made the call, so what is pending now and was not before is ours.
SizeSignalBlocked::~SizeSignalBlocked() {
  const int saved = errno;
  const sigset_t set = size_signal();
  const timespec at_once{0, 0};
  if (!was_pending_ && is_pending()) ::sigtimedwait(&set, nullptr, &at_once);
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  errno = saved;
}

}  // namespace posix
}  // namespace tzc
