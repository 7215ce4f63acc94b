// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <thread>

namespace tzc {
namespace detail {

/// Starts a thread of the transport. It blocks all signals but those of its own faults: they belong to the user's threads, as
/// with roscpp's own threads. False, with a throttled warning, when the system gives no thread.
bool start_transport_thread(std::thread& thread, std::function<void()> body);

/// The same for one that nobody waits for, with a small stack: for TZC's own code and roscpp's, none of users.
bool start_small_transport_thread(const char* name, std::function<void()> body);

/// Runs one job of such a thread, and destroys what it holds, which may take locks. An exception (no memory, no descriptor) ends the
/// job, with a throttled warning, and not the node. Once exit() has begun nothing runs, and nothing is destroyed.
void run_job(std::function<void()> job);

}  // namespace detail
}  // namespace tzc
