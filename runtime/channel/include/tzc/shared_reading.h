// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <functional>

// A message to a subscriber with SubscriberOptions::shared_thread wakes the library's reader thread, and when on_message
// hands it to another thread, that one, too: two wake-ups in a row. A thread that has nothing else to do can wait here
// for its work instead. It then reads for these subscribers, on_message included, and one wake-up is left.

namespace tzc {
namespace channel {

/// Reads in the place of the library's thread, and sleeps while nothing comes: until `wanted` returns true or the time
/// is over. While the caller does something else, the library's thread reads. `wanted` is called on this thread, often,
/// and must not block. False, at once: no such subscriber was created yet, the system has no futex that processes share,
/// or another thread is here; wait in another way then. Thread-safe.
bool read_while_idle(std::chrono::nanoseconds most, const std::function<bool()>& wanted);

/// Makes a thread that sleeps in read_while_idle ask `wanted` again: call it after each event that changes the answer.
/// One atomic load when there is none. Thread-safe.
void wake_idle_reader();

}  // namespace channel
}  // namespace tzc
