// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <vector>

namespace tzc {
namespace bench {

// The benchmark's processes, and the signals that end it. For the main thread of a program with one thread.

/// Runs body in a process of its own, which exits with 0 afterwards. It dies when this process dies, and SIGINT
/// does not reach it: this process decides what an interruption means.
pid_t in_child(const std::function<void()>& body);

/// From now on SIGINT and SIGTERM do not end this process: wait_for and interrupted report them.
void hold_interrupts();

/// Of a command that such a signal has ended, as of a shell's.
constexpr int interrupted_status = 130;

/// Whether SIGINT or SIGTERM has come since hold_interrupts.
bool interrupted();

enum class Ending { exited, failed, interrupted };

/// Waits until the child ends. failed: with a status other than 0, or by a signal. interrupted: it still runs.
Ending wait_for(pid_t child);

/// Whether none of the children has ended yet.
bool all_run(const std::vector<pid_t>& children);

/// Waits for children that end by themselves, for so long at most: those that are killed leave their shared memory behind.
void let_end(const std::vector<pid_t>& children, std::chrono::milliseconds most);

/// Kills the children and waits for them.
void stop(const std::vector<pid_t>& children);

}  // namespace bench
}  // namespace tzc
