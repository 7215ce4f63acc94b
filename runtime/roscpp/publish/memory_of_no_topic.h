// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/memory.h>

#include <optional>

namespace tzc {
namespace detail {

/// What tzc-monitor calls it. No topic can have this name.
constexpr const char* no_topic = "(no topic)";

/// From now on there is a memory_of_no_topic(): a topic of this process has shared memory. Thread-safe.
void note_topic_with_memory();

/// None: no message was built there. Thread-safe.
std::optional<MemoryStats> stats_of_no_topic();

}  // namespace detail
}  // namespace tzc
