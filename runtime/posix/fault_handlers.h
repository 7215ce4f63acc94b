// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>

namespace tzc {
namespace posix {

/// A signal as its handler gets it.
struct Fault {
  int number;
  siginfo_t* info;
  void* context;
};

/// True: the fault is dealt with, the instruction may be tried again. Async-signal-safe.
using FaultResolver = bool (*)(const Fault& fault);

/// Makes `resolver` the first to hear of a SIGSEGV. What it does not resolve goes to the handlers of other code: one that
/// was installed since comes first, then the one before it, down to the one that was there at first. Handlers are only
/// found here, so call this again whenever the resolver must work. When nothing has changed it is one system call.
/// False: the system refuses. Thread-safe, one resolver for the process.
bool stay_first(FaultResolver resolver);

}  // namespace posix
}  // namespace tzc
