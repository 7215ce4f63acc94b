// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <vector>

namespace tzc {
namespace bench {

// The benchmark's processes, and the signals that end it. For the main thread of a program with one thread.

/// Runs body in a process of its own, which exits with 0 afterwards. It dies when this process dies, and SIGINT, SIGHUP
/// and SIGQUIT do not reach it: this process decides what an interruption means. What body throws ends the child. Throws
/// std::system_error where the system starts no more processes.
pid_t in_child(const std::function<void()>& body);

/// So many children, numbered from 0. All or none: those that have started are gone when it throws.
std::vector<pid_t> in_children(std::size_t count, const std::function<void(std::size_t number)>& body);

/// In a child that becomes another program, for which its parent waits whatever comes: a terminal's signals do to it
/// what they would have done to the parent.
void take_interrupts_again();

/// From now on SIGINT, SIGTERM, SIGHUP and SIGQUIT do not end this process: wait_for and interrupted report them. SIGHUP
/// and SIGQUIT stay ignored where they are, as under nohup.
void hold_interrupts();

/// Of a command that such a signal has ended, as of a shell's.
constexpr int interrupted_status = 130;

/// Whether such a signal has come since hold_interrupts.
bool interrupted();

/// Sleeps until a child ends or such a signal comes, for so long at most. Without hold_interrupts nobody tells: a moment.
void wait_for_news(std::chrono::milliseconds most);

enum class Ending { exited, failed, interrupted };

/// Waits until the child ends. failed: with a status other than 0, by a signal, or there is no such child. interrupted: it
/// still runs.
Ending wait_for(pid_t child);

/// Whether none of the children has ended yet.
bool all_run(const std::vector<pid_t>& children);

/// Waits for children that end by themselves, for so long at most: those that are killed leave their shared memory behind.
void let_end(const std::vector<pid_t>& children, std::chrono::milliseconds most);

/// Kills the children and waits for them. What is no process (0, -1) is left out: to the kernel these are many.
void stop(const std::vector<pid_t>& children);

}  // namespace bench
}  // namespace tzc
