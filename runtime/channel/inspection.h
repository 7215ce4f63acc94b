// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "channel/latency_histogram.h"
#include "tzc/channel.h"

// What statistics pages and traces show of connections and messages, beyond the public counters. Slow; not on the way of a message.

namespace tzc {
namespace channel {

/// A block that a subscriber has taken and not released, as a name that no other block of the connection has had so far.
struct HeldBlock {
  const void* file;
  std::uint32_t slot, generation;
};

struct ConnectionInspection {
  std::uint64_t shared_bytes = 0;  ///< of blocks that were sent, each time they were sent
  /// Records taken back before the subscriber took them; ConnectionStats::dropped is their sum.
  std::uint64_t dropped_for_queue = 0;   ///< queue_size was exceeded
  std::uint64_t dropped_for_memory = 0;  ///< best_effort needed the block
  std::uint64_t dropped_at_end = 0;      ///< the subscriber left, or the connection broke
  std::vector<HeldBlock> held;
};

struct SubscriberInspection {
  LatencyCounts latencies{};       ///< from the making of a record until it was taken here
  std::uint64_t shared_bytes = 0;  ///< of blocks that were taken
};

ConnectionInspection inspect(const Connection& connection);
SubscriberInspection inspect(const Subscriber& subscriber);
/// What traces call a message that was received, in its publisher's process, too. 0: this process writes no trace.
std::uint64_t trace_id(const Message& message);

}  // namespace channel
}  // namespace tzc
