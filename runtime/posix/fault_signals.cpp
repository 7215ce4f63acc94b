// SPDX-License-Identifier: BSD-3-Clause
#include "posix/fault_signals.h"

#include <pthread.h>

namespace tzc {
namespace posix {
namespace {

constexpr int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGTRAP};

}  // namespace

sigset_t all_but_faults() noexcept {
  sigset_t others;
  sigfillset(&others);
  for (const int fault : faults) sigdelset(&others, fault);
  return others;
}

void unblock_faults() noexcept {
  sigset_t set;
  sigemptyset(&set);
  for (const int fault : faults) sigaddset(&set, fault);
  pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace posix
}  // namespace tzc
