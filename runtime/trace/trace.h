// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "trace/event.h"
#include "trace/names.h"
#include "trace/recent_messages.h"

// A trace of what happens to each message, for a person who asks where the time goes: TZC_TRACE=FILE (docs/traces.md).
//
//   publish, take, callback --record()--> queue of events --a thread of its own--> FILE.PID
//
// Who records never waits: a full queue drops the event, and counts it. Without TZC_TRACE there is no queue, thread or file,
// and each place that would record costs one branch on `active`.

namespace tzc {
namespace trace {

/// This process was asked for a trace. Set when the library is loaded, and not changed afterwards.
extern bool active;

/// CLOCK_MONOTONIC, in nanoseconds.
std::uint64_t now() noexcept;

/// A copy of a topic's name that lives as long as the process. Begins the trace. May wait: not on the way of a message.
const char* keep(const std::string& topic);
/// Begins the trace, too. May wait.
void name_channel(const std::string& address, const ChannelName& name);
/// The address itself for a channel without a name. May wait.
ChannelName name_of_channel(const std::string& address);
/// What the trace calls this process; otherwise, its program's name. Begins the trace. May wait.
void name_process(const std::string& name);

/// Adds a step that ends now, on this thread. Never waits, does not allocate. Any thread.
void record(Step step, Arrow arrow, std::uint64_t message, const char* topic, std::uint64_t begin_ns,
            std::uint64_t bytes = 0) noexcept;
/// The same for a step that ended at `end_ns`. Thread 0: this one.
void record(const Event& event) noexcept;

/// The messages that this process received.
RecentMessages& recent();

}  // namespace trace
}  // namespace tzc
