// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>

namespace tzc {
namespace posix {

// A write to a received message is a fault that a handler of SIGSEGV answers (write_fault.h). The kernel ends a process whose
// thread faults while that signal is blocked, so no thread that runs code of the program may block it.

/// What a thread of the library blocks: all signals but those of its own faults.
sigset_t all_but_faults() noexcept;

/// Unblocks the signals of faults on this thread. One system call.
void unblock_faults() noexcept;

}  // namespace posix
}  // namespace tzc
