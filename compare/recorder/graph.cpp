// SPDX-License-Identifier: BSD-3-Clause
#include "recorder/graph.h"

#include <ros/master.h>
#include <ros/this_node.h>

#include "recorder/xmlrpc.h"

namespace tzc::compare {
namespace {

using XmlRpc::XmlRpcValue;

using Nodes = std::map<std::string, std::set<std::string>>;

/// [[topic, [node, ...]], ...]
Nodes read_nodes(XmlRpcValue& list) {
  Nodes nodes;
  for (int i = 0; i < list.size(); ++i) {
    XmlRpcValue& names = list[i][1];
    for (int j = 0; j < names.size(); ++j) {
      const std::string node = names[j];
      if (node != "/rosout" && node != ros::this_node::getName()) nodes[list[i][0]].insert(node);
    }
  }
  return nodes;
}

void append(std::string& text, const Nodes& nodes) {
  for (const auto& [topic, names] : nodes) {
    text += topic;
    for (const std::string& name : names) text += " " + name;
    text += "\n";
  }
}

std::string master_uri() {
  return "http://" + ros::master::getHost() + ":" + std::to_string(ros::master::getPort()) + "/";
}

}  // namespace

std::set<std::string> Graph::nodes() const {
  std::set<std::string> all;
  for (const Nodes* nodes : {&publishers, &subscribers})
    for (const auto& [topic, names] : *nodes) all.insert(names.begin(), names.end());
  return all;
}

std::string Graph::fingerprint() const {
  std::string text;
  append(text, publishers);
  append(text, subscribers);
  return std::to_string(std::hash<std::string>()(text));
}

bool read_graph(Graph& graph) {
  auto state = call(master_uri(), "getSystemState");
  auto types = call(master_uri(), "getTopicTypes");
  if (!state || !types || state->size() < 2) return false;
  graph.publishers = read_nodes((*state)[0]);
  graph.subscribers = read_nodes((*state)[1]);
  for (int i = 0; i < types->size(); ++i)
    graph.types[(*types)[i][0]] = static_cast<std::string>((*types)[i][1]);
  return true;
}

}  // namespace tzc::compare
