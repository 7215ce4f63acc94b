// SPDX-License-Identifier: BSD-3-Clause
#include "diagnostics/status.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "latency.h"
#include "problems.h"
#include "words.h"

namespace tzc::monitor {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using diagnostic_msgs::KeyValue;

/// A node on TCPROS works as it did without TZC; one that is stopped or loses messages does not.
std::uint8_t level_of(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::stopped:
    case ProblemKind::silent:
      return DiagnosticStatus::ERROR;
    case ProblemKind::memory:
    case ProblemKind::lost:
      return DiagnosticStatus::WARN;
    case ProblemKind::tcpros:
      return DiagnosticStatus::OK;
  }
  return DiagnosticStatus::WARN;
}

void add_value(DiagnosticStatus& status, const std::string& key, const std::string& value) {
  KeyValue pair;
  pair.key = key;
  pair.value = value;
  status.values.push_back(pair);
}

/// Only a shared connection counts more than its messages.
std::string received(const Subscription& one) {
  const std::string text = fmt::format("{} messages over {}", one.messages, name(one.transport));
  if (one.transport != Transport::shared) return text;
  return fmt::format("{}, latency {}, holds {}, lost {}", text, latency_words(one.latencies),
                     one.held_messages, one.lost);
}

void add_counts(const Node& node, DiagnosticStatus& status) {
  for (const Topic& topic : node.topics)
    add_value(status, topic.name,
              fmt::format("{} messages, {} of {} in use, {} without memory, {} lost", topic.counters.messages,
                          short_bytes(static_cast<double>(topic.memory.used)),
                          short_bytes(static_cast<double>(topic.memory.size)), topic.counters.exhausted,
                          topic.counters.dropped + topic.counters.revoked));
  for (const Subscription& one : node.subscriptions)
    add_value(status, fmt::format("{} from {}", one.topic, one.publisher), received(one));
}

class Statuses {
 public:
  explicit Statuses(const std::string& host) : host_(host) {}

  DiagnosticStatus& of(const std::string& node) {
    const auto [place, is_new] = by_node_.try_emplace(node);
    DiagnosticStatus& status = place->second;
    if (!is_new) return status;
    status.name = "tzc: " + node;
    status.hardware_id = host_;
    status.message = "OK";
    return status;
  }

  void add(const Problem& problem) {
    DiagnosticStatus& status = of(problem.node);
    const std::uint8_t level = level_of(problem.kind);
    if (level > status.level) {
      status.level = level;
      status.message = problem.text;
    }
    add_value(status, name(problem.kind), problem.text);
  }

  std::vector<DiagnosticStatus> all() const {
    std::vector<DiagnosticStatus> statuses;
    for (const auto& one : by_node_) statuses.push_back(one.second);
    return statuses;
  }

 private:
  const std::string host_;
  std::map<std::string, DiagnosticStatus> by_node_;
};

}  // namespace

std::vector<DiagnosticStatus> statuses(const std::vector<Node>& nodes, const std::string& host) {
  Statuses found(host);
  for (const Node& node : nodes) add_counts(node, found.of(node.name));
  for (const Problem& problem : problems(nodes)) found.add(problem);
  return found.all();
}

}  // namespace tzc::monitor
