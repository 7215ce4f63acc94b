// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/latency.h"
#include "engine/verdict.h"
#include "run/run.h"

namespace tzc::compare {

/// The cost of one topic's messages in one run.
struct Copies {
  std::uint64_t messages = 0;                            ///< sent, once for each connection
  std::uint64_t socket_bytes = 0;                        ///< written for those
  std::size_t connections = 0, shared = 0;               ///< of those, through shared memory
  std::optional<std::uint64_t> published, copied_bytes;  ///< of a ported publisher: copied into shared memory

  double bytes_per_delivery() const {
    return messages == 0 ? 0 : static_cast<double>(socket_bytes) / static_cast<double>(messages);
  }
};

/// The cost of one run.
struct Resources {
  std::map<std::string, double> cpu_seconds;  ///< by node
  double seconds = 0;
  std::map<std::string, Copies> copies;                            ///< by topic
  std::map<std::pair<std::string, std::string>, Latency> latency;  ///< by topic and node
};

/// What was not compared as asked.
struct Omissions {
  std::vector<std::string> topics;    ///< by the options
  std::set<std::string> late_topics;  ///< the recorder came late, so nothing is known of their first messages
  std::vector<std::string> unknown_fields;  ///< were to be left out, and no message type has them
};

/// The result of a comparison.
struct Result {
  std::string original, port;  ///< workspaces
  int original_runs = 0;
  std::vector<StreamVerdict> verdicts;
  Resources original_resources, port_resources;
  std::set<std::string> own_failures;   ///< nodes that died in a run of the original
  std::set<std::string> port_failures;  ///< in the port's, and in none of the original's
  Omissions omissions;
  bool judges_before = false, judges_after = false;

  bool is_different() const { return !port_failures.empty() || compare::is_different(verdicts); }
};

Resources resources_of(const Run& run, const Recording& recording);

}  // namespace tzc::compare
