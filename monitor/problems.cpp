// SPDX-License-Identifier: BSD-3-Clause
#include "problems.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "why.h"
#include "words.h"

namespace tzc::monitor {
namespace {

class Search {
 public:
  std::vector<Problem> all(const std::vector<Node>& nodes) {
    for (const Node& node : nodes) look_at_state(node);
    for (const Node& node : nodes) look_at_others(node);
    for (const auto& [pid, text] : stopped_)
      found_.push_back({ProblemKind::stopped, text.first, text.second});
    for (const Node& node : nodes)
      for (std::size_t i = 0; i < node.topics.size(); ++i)
        look_at_topic(node, node.topics[i], i < node.rates.size() ? node.rates[i] : std::nullopt);
    for (const OneSided& one : one_sided(nodes)) look_at_one_sided(one, nodes);
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Problem& a, const Problem& b) { return a.kind < b.kind; });
    return std::move(found_);
  }

 private:
  void look_at_state(const Node& node) {
    if (node.state == State::stopped)
      stopped_[node.pid] = {
          node.name,
          fmt::format("{} (process {}) is stopped, for {:.0f} s so far. kill -CONT {} lets it go on.",
                      node.name, node.pid, node.age_s, node.pid)};
    if (node.state == State::silent)
      found_.push_back({ProblemKind::silent, node.name,
                        fmt::format("{} (process {}) runs and has updated nothing for {:.0f} s: "
                                    "is the machine overloaded, or does it hang?",
                                    node.name, node.pid, node.age_s)});
  }

  void stopped(const std::string& name, std::uint32_t pid) {
    if (stopped_.count(pid) == 0)
      stopped_[pid] = {
          name, fmt::format("{} (process {}) is stopped. kill -CONT {} lets it go on.", name, pid, pid)};
  }

  void look_at_others(const Node& node) {
    for (const Topic& topic : node.topics)
      for (const Connection& connection : topic.connections)
        if (connection.is_stopped) stopped(connection.subscriber, connection.pid);
    for (const Subscription& subscription : node.subscriptions)
      if (subscription.is_stopped) stopped(subscription.publisher, subscription.pid);
  }

  void look_at_topic(const Node& node, const Topic& topic, const std::optional<Rates>& rates) {
    const bool is_short_now = rates ? rates->exhausted > 0 : topic.counters.exhausted > 0;
    if (is_short_now) found_.push_back({ProblemKind::memory, node.name, memory_text(node, topic)});
    for (const Connection& connection : topic.connections) look_at_connection(node, topic, connection);
  }

  /// Who keeps the memory stands in it: without that, the size alone looks guilty.
  static std::string memory_text(const Node& node, const Topic& topic) {
    const TopicCounts lost{topic.counters.exhausted, topic.counters.dropped};
    const std::string messages =
        fmt::format("{} messages {}", lost.exhausted,
                    lost.dropped > 0 ? "were dropped or sent serialized" : "were sent serialized");
    const std::string size = short_bytes(static_cast<double>(topic.memory.size));
    if (topic.memory.used == 0)
      return fmt::format(
          "{} finds no shared memory for messages of {}: {}. None of {} is in use now: it was full for a "
          "moment, or one message does not fit, or the system or ~tzc/memory_ceiling refused more. The "
          "node's "
          "log says which, and the size to set.",
          node.name, topic.name, messages, size);
    std::string text =
        fmt::format("{} has no shared memory left for {}: {}; {} of {} are in use.", node.name, topic.name,
                    messages, short_bytes(static_cast<double>(topic.memory.used)), size);
    for (const Connection& connection : topic.connections)
      if (connection.held + connection.in_flight > 1)
        text += fmt::format(" {} holds {} blocks{}, {} messages are in flight to it{}.",
                            connection.subscriber, connection.held, held_for(connection),
                            connection.in_flight, connection.is_stopped ? " (stopped)" : "");
    return text + " Raise ~tzc/memory_size, or let subscribers keep less.";
  }

  static std::string held_for(const Connection& connection) {
    return connection.oldest_held_s < 1 ? "" : fmt::format(" for up to {:.0f} s", connection.oldest_held_s);
  }

  static bool goes_through_sockets(Transport transport) {
    return transport == Transport::tcpros || transport == Transport::udpros;
  }

  void look_at_connection(const Node& node, const Topic& topic, const Connection& connection) {
    if (goes_through_sockets(connection.transport))
      found_.push_back(
          {ProblemKind::tcpros, node.name,
           fmt::format("{} sends {} to {} over {}: {}{}", node.name, topic.name, connection.subscriber,
                       name(connection.transport), named_reason(connection), remedy(connection.reason))});
    const Losses lost = connection.lost_since.value_or(connection.losses());
    // A stopped process loses messages, of course; its line says what to do.
    if (lost.sum() > 0 && connection.transport == Transport::shared && !connection.is_stopped)
      found_.push_back({ProblemKind::lost, connection.subscriber,
                        fmt::format("{} did not take {} messages of {} from {} in time{}: {}.",
                                    connection.subscriber, lost.sum(), topic.name, node.name,
                                    unless_all(lost, connection.losses()), causes(lost))});
  }

  static std::string unless_all(const Losses& lost, const Losses& all) {
    return lost.sum() == all.sum() ? "" : fmt::format(" ({} since it connected)", all.sum());
  }

  static std::string causes(const Losses& lost) {
    if (lost.for_memory == 0) return "its queue was full";
    if (lost.for_queue == 0) return "their memory was needed";
    return fmt::format("{} because its queue was full, {} because their memory was needed", lost.for_queue,
                       lost.for_memory);
  }

  /// Nobody else tells of it, so it is the subscriber's problem.
  void look_at_one_sided(const OneSided& one, const std::vector<Node>& nodes) {
    if (goes_through_sockets(one.subscription->transport))
      found_.push_back({ProblemKind::tcpros, one.node->name, sentence_of(one, nodes)});
  }

  static std::string remedy(const std::string& reason) {
    const std::string text = advice(reason);
    return text.empty() ? text : " " + text;
  }

  struct TopicCounts {
    std::uint64_t exhausted, dropped;
  };

  std::vector<Problem> found_;
  std::map<std::uint32_t, std::pair<std::string, std::string>> stopped_;  ///< by process: name and text
};

}  // namespace

const char* name(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::stopped:
      return "stopped";
    case ProblemKind::silent:
      return "silent";
    case ProblemKind::memory:
      return "memory";
    case ProblemKind::lost:
      return "lost";
    case ProblemKind::tcpros:
      return "TCPROS";
  }
  return "unknown";
}

std::vector<Problem> problems(const std::vector<Node>& nodes) {
  return Search().all(nodes);
}

}  // namespace tzc::monitor
