// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <thread>

#include "tzc/error.h"

namespace tzc {
namespace posix {

/// Starts a thread that handles no signals but those of its own faults (the others stay with the application's own threads; a
/// fault whose signal is blocked would end the process without asking a handler). `name` is what ps
/// and debuggers show, at most 15 characters. Error: the system has no thread left.
Expected<std::thread> start_thread(const char* name, std::function<void()> body);

/// The same for one that nobody waits for and that runs little code of users: it has 1 MB of stack beside what the program's
/// thread-local variables take, or less where the program's threads have less. (A stack counts in full against a limit on a process's data.)
Status start_small_thread(const char* name, std::function<void()> body);

}  // namespace posix
}  // namespace tzc
