// SPDX-License-Identifier: BSD-3-Clause
#include "recorder/traffic.h"

#include <ros/master.h>

#include "recorder/xmlrpc.h"

namespace tzc::compare {
namespace {

using XmlRpc::XmlRpcValue;

std::string look_up(const std::string& node) {
  const std::string master =
      "http://" + ros::master::getHost() + ":" + std::to_string(ros::master::getPort()) + "/";
  auto uri = call(master, "lookupNode", node);
  return uri && uri->getType() == XmlRpcValue::TypeString ? static_cast<std::string>(*uri) : std::string();
}

}  // namespace

void Traffic::update(const Graph& graph) {
  std::set<std::string> publishers;
  for (const auto& [topic, nodes] : graph.publishers) publishers.insert(nodes.begin(), nodes.end());
  for (const std::string& node : publishers) update_node(node);
}

void Traffic::update_node(const std::string& node) {
  std::string& uri = uris_[node];
  if (uri.empty()) uri = look_up(node);
  if (uri.empty()) return;
  auto stats = call(uri, "getBusStats");
  auto info = call(uri, "getBusInfo");
  if (!stats || !info || stats->getType() != XmlRpcValue::TypeArray || stats->size() < 1) return;
  XmlRpcValue& topics = (*stats)[0];
  for (int t = 0; t < topics.size(); ++t) {
    XmlRpcValue& list =
        topics[t][1];  // [[connection, bytes, data bytes, messages, 0], ...]; rospy has a number first
    if (list.getType() != XmlRpcValue::TypeArray) continue;
    for (int c = 0; c < list.size(); ++c) {
      const auto bytes = static_cast<std::uint32_t>(static_cast<int>(list[c][1]));
      const auto messages = static_cast<std::uint32_t>(static_cast<int>(list[c][3]));
      count(connections_[{topics[t][0], node, list[c][0]}], bytes, messages);
    }
  }
  for (int i = 0; i < info->size(); ++i) {  // [connection, destination, direction, transport, topic, ...]
    XmlRpcValue& entry = (*info)[i];
    if (entry.size() < 5 || entry[4].getType() != XmlRpcValue::TypeString) continue;
    const auto found = connections_.find({entry[4], node, entry[0]});
    if (found == connections_.end()) continue;
    found->second.subscriber = static_cast<std::string>(entry[1]);
    found->second.transport = static_cast<std::string>(entry[3]);
  }
}

void Traffic::count(Connection& connection, std::uint32_t bytes, std::uint32_t messages) {
  // Another link has taken the connection's number: one that moved to shared memory or back counts from 0.
  if (messages < connection.last_messages) connection.last_messages = connection.last_bytes = 0;
  connection.bytes += static_cast<std::uint32_t>(bytes - connection.last_bytes);  // it may have wrapped round
  connection.messages += messages - connection.last_messages;
  connection.last_bytes = bytes;
  connection.last_messages = messages;
}

nlohmann::json Traffic::to_json() const {
  nlohmann::json all = nlohmann::json::array();
  for (const auto& [key, connection] : connections_) {
    all.push_back({{"topic", std::get<0>(key)},
                   {"from", std::get<1>(key)},
                   {"to", connection.subscriber},
                   {"transport", connection.transport},
                   {"bytes", connection.bytes},
                   {"messages", connection.messages}});
  }
  return all;
}

}  // namespace tzc::compare
