// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <tuple>

#include "recorder/graph.h"

namespace tzc::compare {

/// The traffic of the nodes' connections, as the nodes report it (getBusStats, getBusInfo).
class Traffic {
 public:
  /// Asks every node that publishes. Their counters have 32 bits: ask before 4 GB have gone through a
  /// connection.
  void update(const Graph& graph);
  /// [{"topic", "from", "to", "transport", "bytes", "messages"}, ...]
  nlohmann::json to_json() const;

 private:
  struct Connection {
    std::string subscriber, transport;
    std::uint32_t last_bytes = 0, last_messages = 0;
    std::uint64_t bytes = 0, messages = 0;
  };
  using Key = std::tuple<std::string, std::string, int>;  // topic, node, connection

  void update_node(const std::string& node);
  static void count(Connection& connection, std::uint32_t bytes, std::uint32_t messages);

  std::map<std::string, std::string> uris_;
  std::map<Key, Connection> connections_;
};

}  // namespace tzc::compare
