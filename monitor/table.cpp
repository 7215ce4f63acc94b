// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include <fmt/format.h>

#include <algorithm>

#include "words.h"

namespace tzc::monitor {
namespace {

constexpr const char* bold = "1";
constexpr const char* red = "31";
constexpr const char* green = "32";
constexpr const char* yellow = "33";

class Table {
 public:
  Table(const std::vector<Node>& nodes, bool has_colours) : nodes_(nodes), has_colours_(has_colours) {
    for (const Node& node : nodes)
      for (const Topic& topic : node.topics) widen(topic);
  }

  std::string text() {
    head();
    for (const Node& node : nodes_) {
      add_node(node);
      for (std::size_t i = 0; i < node.topics.size(); ++i)
        add_topic(node.topics[i], i < node.rates.size() ? node.rates[i] : std::nullopt);
    }
    return std::move(text_);
  }

 private:
  void widen(const Topic& topic) {
    names_ = std::max(names_, topic.name.size());
    types_ = std::max(types_, topic.type.size());
    for (const Connection& connection : topic.connections)
      subscribers_ = std::max(subscribers_, connection.subscriber.size());
  }

  std::string paint(const char* colour, const std::string& text) const {
    return has_colours_ ? fmt::format("\x1b[{}m{}\x1b[0m", colour, text) : text;
  }
  /// A count that should be 0.
  std::string alarm(std::uint64_t count, int width) const {
    const std::string text = fmt::format("{:>{}}", count, width);
    return count == 0 ? text : paint(red, text);
  }

  void head() {
    const std::string line =
        fmt::format("  {:{}}  {:{}}  {:>7}  {:>8}  {:>8}  {:>8}  {:>6}  {:>9}  {:>6}  {:>9}  {:>7}  {:>7}",
                    "TOPIC", names_, "TYPE", types_, "MSG/S", "SHARED/S", "SERIAL/S", "COPIED/S", "USED",
                    "COMMITTED", "SIZE", "EXHAUSTED", "DROPPED", "REVOKED");
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

  void add_topic(const Topic& topic, const std::optional<Rates>& rates) {
    const auto rate = [](double value) { return fmt::format("{:.1f}", value); };
    text_ +=
        fmt::format("  {:{}}  {:{}}  {:>7}  {:>8}  {:>8}  {:>8}", topic.name, names_, topic.type, types_,
                    rates ? rate(rates->messages) : "-", rates ? rate(rates->shared) : "-",
                    rates ? rate(rates->serialized) : "-", rates ? short_bytes(rates->copied_bytes) : "-");
    text_ += fmt::format(
        "  {:>6}  {:>9}  {:>6}  {}  {}  {}\n", short_bytes(static_cast<double>(topic.memory.used)),
        short_bytes(static_cast<double>(topic.memory.committed)),
        short_bytes(static_cast<double>(topic.memory.size)), alarm(topic.counters.exhausted, 9),
        alarm(topic.counters.dropped, 7), alarm(topic.counters.revoked, 7));
    for (const Connection& connection : topic.connections) add_connection(connection);
  }

  void add_connection(const Connection& connection) {
    const bool is_shared = connection.transport == Transport::shared;
    const std::string transport = fmt::format("{:10}", name(connection.transport));
    const std::string rate =
        connection.messages_per_s ? fmt::format("{:.1f}/s", *connection.messages_per_s) : "-";
    text_ += fmt::format("    -> {:{}}  {}  {:>9}  sent {}", connection.subscriber, subscribers_,
                         paint(is_shared ? green : yellow, transport), rate, connection.messages);
    if (is_shared)
      text_ += fmt::format(", in flight {}, holds {}, revoked {}", connection.in_flight, connection.held,
                           connection.revoked);
    else
      text_ += ": " + connection.reason;
    if (connection.is_stopped) text_ += paint(red, "  stopped");
    text_ += "\n";
  }

  const std::vector<Node>& nodes_;
  const bool has_colours_;
  std::size_t names_ = 5, types_ = 4, subscribers_ = 0;
  std::string text_;
};

}  // namespace

std::string table(const std::vector<Node>& nodes, bool has_colours) {
  return Table(nodes, has_colours).text();
}

}  // namespace tzc::monitor
