// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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

/// One subscriber of a topic of one node.
struct Connection {
  std::string subscriber;
  Transport transport = Transport::unknown;
  std::string reason;  ///< why it is not on shared memory
  std::uint64_t messages = 0, bytes = 0, in_flight = 0, held = 0, revoked = 0;
  std::uint32_t pid = 0;                 ///< 0: not known
  std::optional<double> messages_per_s;  ///< sent; none: there is only one sample
  bool is_stopped = false;               ///< the subscriber's process
};

struct Topic {
  std::string name, type;
  statistics::TopicCounters counters{};
  statistics::TopicMemory memory{};
  std::vector<Connection> connections;
};

/// What changed between two samples of a topic, per second.
struct Rates {
  double messages = 0, shared = 0, serialized = 0, copied_bytes = 0;
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
  std::vector<std::optional<Rates>> rates;  ///< of each topic; empty: there is only one sample
};

}  // namespace tzc::monitor
