// SPDX-License-Identifier: BSD-3-Clause
#include "filter.h"

#include <algorithm>
#include <set>
#include <utility>

namespace tzc::monitor {

void keep_topic(const std::string& topic, std::vector<Node>& nodes) {
  if (topic.empty()) return;
  std::set<std::string> publishers;  // as subscribers know them
  for (Node& node : nodes) {
    Node kept = node;
    kept.topics.clear();
    kept.rates.clear();
    for (std::size_t i = 0; i < node.topics.size(); ++i) {
      if (node.topics[i].name != global_name(topic)) continue;
      kept.topics.push_back(node.topics[i]);
      if (i < node.rates.size()) kept.rates.push_back(node.rates[i]);
    }
    kept.subscriptions.clear();
    for (const Subscription& one : node.subscriptions)
      if (one.topic == global_name(topic)) {
        publishers.insert(one.publisher);
        kept.subscriptions.push_back(one);
      }
    node = std::move(kept);
  }
  const auto is_other = [&](const Node& node) {
    return node.topics.empty() && node.subscriptions.empty() && publishers.count(node.name) == 0;
  };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), is_other), nodes.end());
}

}  // namespace tzc::monitor
