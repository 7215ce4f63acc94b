// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "statistics/page_layout.h"

namespace tzc::monitor {

enum class Transport { shared, tcpros, udpros, intraprocess, unknown };

/// What the system and the age of the page tell of a process.
enum class State {
  running,
  stopped,  ///< by a signal or a debugger
  silent,   ///< it should have updated its page for some seconds
};

/// Messages that a subscriber could have taken and did not, by cause.
struct Losses {
  std::uint64_t for_queue = 0, for_memory = 0;

  std::uint64_t sum() const { return for_queue + for_memory; }
};

/// One subscriber of a topic of one node.
struct Connection {
  std::string subscriber;
  Transport transport = Transport::unknown;
  std::string reason;  ///< why it is not on shared memory
  std::uint64_t messages = 0, bytes = 0, in_flight = 0, held = 0, revoked = 0;
  std::uint64_t shared_bytes = 0;  ///< of arrays that were sent in shared memory
  std::uint64_t revoked_for_queue = 0, revoked_for_memory = 0, revoked_at_end = 0;  ///< `revoked` by cause
  double oldest_held_s = 0;
  std::uint32_t pid = 0;                     ///< 0: not known
  std::optional<double> messages_per_s;      ///< sent; none: there is only one sample, or nobody counts
  std::optional<double> shared_bytes_per_s;  ///< as above
  std::optional<Losses> lost_since;          ///< since the sample before; none: as above
  bool is_stopped = false;                   ///< the subscriber's process

  /// Since it connected.
  Losses losses() const { return {revoked_for_queue, revoked_for_memory}; }
};

struct Topic {
  std::string name, type;
  statistics::TopicCounters counters{};
  statistics::TopicMemory memory{};
  std::vector<Connection> connections;
};

using Latencies = std::array<std::uint64_t, statistics::latency_buckets>;  ///< as in SubscriptionRow

/// One publisher of a topic that a node subscribes to.
struct Subscription {
  std::string topic, publisher;
  Transport transport = Transport::unknown;
  std::uint64_t messages = 0, lost = 0, bytes = 0, shared_bytes = 0, held_messages = 0, held_bytes = 0;
  Latencies latencies{};                 ///< from publish to take, since the connection began
  std::uint32_t pid = 0;                 ///< of the publisher; 0: not known
  std::optional<double> messages_per_s;  ///< received; none: there is only one sample
  Latencies recent{};                    ///< those of `latencies` since the sample before
  bool is_stopped = false;               ///< the publisher's process
};

/// What changed between two samples of a topic, per second.
struct Rates {
  double messages = 0, shared = 0, serialized = 0, copied_bytes = 0, exhausted = 0;
};

/// One process with a statistics page, as it was sampled.
struct Node {
  std::string name;
  std::uint32_t pid = 0;  ///< as this process sees it
  std::uint64_t started_ns = 0, updated_ns = 0;
  State state = State::running;
  double age_s = 0;  ///< of what is shown
  std::uint32_t left_out = 0;
  std::vector<Topic> topics;
  std::vector<Subscription> subscriptions;
  std::vector<std::optional<Rates>> rates;  ///< of each topic; empty: there is only one sample
};

}  // namespace tzc::monitor
