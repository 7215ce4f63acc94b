// SPDX-License-Identifier: BSD-3-Clause
#include "solve/flow_graph.h"

#include <algorithm>
#include <deque>

namespace tzc::rewriter {

FlowGraph::FlowGraph(const std::vector<Flow>& flows) {
  for (const Flow& flow : flows) {
    edges_[flow.from].push_back({flow.to, &flow});
    edges_[flow.to].push_back({flow.from, &flow});
  }
}

const std::vector<FlowGraph::Edge>& FlowGraph::edges_of(const EntityId& entity) const {
  static const std::vector<Edge> none;
  const auto found = edges_.find(entity);
  return found == edges_.end() ? none : found->second;
}

std::set<EntityId> FlowGraph::reachable(const EntityId& from) const {
  std::set<EntityId> seen{from};
  std::deque<EntityId> queue{from};
  while (!queue.empty()) {
    const EntityId here = queue.front();
    queue.pop_front();
    for (const Edge& edge : edges_of(here))
      if (seen.insert(edge.to).second) queue.push_back(edge.to);
  }
  return seen;
}

std::vector<FlowStep> FlowGraph::path(const EntityId& from, const EntityId& to) const {
  std::map<EntityId, Edge> came_by{{from, {from, nullptr}}};  // entity -> the edge back to its predecessor
  std::deque<EntityId> queue{from};
  while (!queue.empty() && came_by.count(to) == 0) {
    const EntityId here = queue.front();
    queue.pop_front();
    for (const Edge& edge : edges_of(here))
      if (came_by.emplace(edge.to, Edge{here, edge.flow}).second) queue.push_back(edge.to);
  }
  std::vector<FlowStep> steps;
  if (came_by.count(to) == 0) return steps;
  for (EntityId here = to; here != from; here = came_by.at(here).to) {
    const Flow& flow = *came_by.at(here).flow;
    steps.push_back({flow.where, flow.what});
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

}  // namespace tzc::rewriter
