// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include <fmt/format.h>

#include <algorithm>

#include "latency.h"
#include "problems.h"
#include "summary.h"
#include "words.h"

namespace tzc::monitor {
namespace {

constexpr const char* bold = "1";
constexpr const char* red = "31";
constexpr const char* green = "32";
constexpr const char* yellow = "33";

std::string per_second(const std::optional<double>& rate) {
  return rate ? fmt::format("{:.1f}/s", *rate) : "-";
}

std::string bytes(std::uint64_t count) {
  return short_bytes(static_cast<double>(count));
}

/// A phrase about a count, only when there is something to say.
std::string unless_0(std::uint64_t count, const std::string& phrase) {
  return count == 0 ? "" : fmt::format(fmt::runtime(phrase), count);
}

class Table {
 public:
  Table(const std::vector<Node>& nodes, bool has_colours) : nodes_(nodes), has_colours_(has_colours) {
    for (const Node& node : nodes) {
      for (const Topic& topic : node.topics) widen(topic);
      for (const Subscription& one : node.subscriptions)
        peers_ = std::max(peers_, one.topic.size() + one.publisher.size() + 6);
    }
  }

  std::string text() {
    add_problems();
    head();
    for (const Node& node : nodes_) {
      add_node(node);
      for (std::size_t i = 0; i < node.topics.size(); ++i)
        add_topic(node.topics[i], i < node.rates.size() ? node.rates[i] : std::nullopt);
      for (const Subscription& one : node.subscriptions) add_subscription(one);
    }
    return std::move(text_);
  }

 private:
  void widen(const Topic& topic) {
    names_ = std::max(names_, topic.name.size());
    for (const Connection& connection : topic.connections)
      peers_ = std::max(peers_, connection.subscriber.size());
  }

  std::string paint(const char* colour, const std::string& text) const {
    return has_colours_ ? fmt::format("\x1b[{}m{}\x1b[0m", colour, text) : text;
  }
  /// A count that should be 0.
  std::string alarm(std::uint64_t count, int width) const {
    const std::string text = fmt::format("{:>{}}", count, width);
    return count == 0 ? text : paint(red, text);
  }
  std::string paint(Transport transport) const {
    const bool is_good = transport == Transport::shared || transport == Transport::intraprocess;
    return paint(is_good ? green : yellow, fmt::format("{:10}", name(transport)));
  }

  void add_problems() {
    const std::vector<Problem> found = problems(nodes_);
    text_ += paint(found.empty() ? green : red, summary(nodes_, found)) + "\n\n";
    if (found.empty()) return;
    text_ += paint(bold, "PROBLEMS") + "\n";
    for (const Problem& problem : found)
      text_ += fmt::format(
          "  {}  {}\n",
          paint(problem.kind == ProblemKind::tcpros ? yellow : red, fmt::format("{:7}", name(problem.kind))),
          problem.text);
    text_ += "\n";
  }

  void head() {
    const std::string line = fmt::format(
        "  {:{}}  {:>6}  {:>8}  {:>8}  {:>8}  {:>6}  {:>6}  {:>6}  {:>6}  {:>6}  {}", "TOPIC", names_,
        "MSG/S", "SERIAL/S", "SAVED/S", "COPIED/S", "USED", "PEAK", "SIZE", "NO MEM", "LOST", "TYPE");
    text_ += paint(bold, line) + "\n";
  }

  void add_node(const Node& node) {
    std::string state = name(node.state);
    if (node.state != State::running)
      state = paint(node.state == State::stopped ? red : yellow,
                    fmt::format("{}, as of {:.0f} s ago", state, node.age_s));
    text_ += fmt::format("{}  process {}  {}\n", paint(bold, node.name), node.pid, state);
    if (node.left_out > 0)
      text_ += fmt::format("  {} further rows have no room in its page\n", node.left_out);
  }

  /// Of all subscribers; none: there is only one sample.
  static std::optional<double> saved(const Topic& topic) {
    std::optional<double> sum;
    for (const Connection& connection : topic.connections)
      if (connection.shared_bytes_per_s) sum = sum.value_or(0) + *connection.shared_bytes_per_s;
    return sum;
  }

  void add_topic(const Topic& topic, const std::optional<Rates>& rates) {
    const auto rate = [](double value) { return fmt::format("{:.1f}", value); };
    const std::optional<double> saved_bytes = saved(topic);
    text_ += fmt::format("  {:{}}  {:>6}  {:>8}  {:>8}  {:>8}", topic.name, names_,
                         rates ? rate(rates->messages) : "-", rates ? rate(rates->serialized) : "-",
                         saved_bytes ? short_bytes(*saved_bytes) : "-",
                         rates ? short_bytes(rates->copied_bytes) : "-");
    text_ += fmt::format("  {:>6}  {:>6}  {:>6}  {}  {}  {}\n", bytes(topic.memory.used),
                         bytes(topic.memory.committed), bytes(topic.memory.size),
                         alarm(topic.counters.exhausted, 6),
                         alarm(topic.counters.dropped + topic.counters.revoked, 6), topic.type);
    for (const Connection& connection : topic.connections) add_connection(connection);
  }

  void add_connection(const Connection& connection) {
    text_ += fmt::format("    -> {:{}}  {}  {:>8}  ", connection.subscriber, peers_,
                         paint(connection.transport), per_second(connection.messages_per_s));
    text_ += connection.transport == Transport::shared ? shared_words(connection) : connection.reason;
    if (connection.is_stopped) text_ += paint(red, "  stopped");
    text_ += "\n";
  }

  std::string shared_words(const Connection& connection) const {
    std::string text = fmt::format("in flight {}, holds {}", connection.in_flight, connection.held);
    if (connection.held > 0 && connection.oldest_held_s >= 1)
      text += fmt::format(" for up to {:.0f} s", connection.oldest_held_s);
    const std::string causes = unless_0(connection.revoked_for_queue, " {} queue full") +
                               unless_0(connection.revoked_for_memory, " {} memory needed") +
                               unless_0(connection.revoked_at_end, " {} at its end");
    return text + fmt::format(", lost {}{}", connection.revoked, causes.empty() ? "" : ":" + causes);
  }

  void add_subscription(const Subscription& one) {
    text_ += fmt::format("    <- {:{}}  {}  {:>8}", fmt::format("{} from {}", one.topic, one.publisher),
                         peers_, paint(one.transport), per_second(one.messages_per_s));
    if (one.transport == Transport::shared) text_ += "  " + received_words(one);
    if (one.is_stopped) text_ += paint(red, "  stopped");
    text_ += "\n";
  }

  static std::string received_words(const Subscription& one) {
    std::string text = "latency " + latency_words(count(one.recent) > 0 ? one.recent : one.latencies);
    if (one.held_messages > 0)
      text += fmt::format(", holds {} ({})", one.held_messages, bytes(one.held_bytes));
    return text + fmt::format(", lost {}", one.lost);
  }

  const std::vector<Node>& nodes_;
  const bool has_colours_;
  std::size_t names_ = 5, peers_ = 0;
  std::string text_;
};

}  // namespace

std::string table(const std::vector<Node>& nodes, bool has_colours) {
  return Table(nodes, has_colours).text();
}

}  // namespace tzc::monitor
