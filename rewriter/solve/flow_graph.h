// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <vector>

#include "model/facts.h"
#include "model/site.h"

namespace tzc::rewriter {

/// The flows as an undirected graph of entities. The flows must outlive it.
class FlowGraph {
 public:
  explicit FlowGraph(const std::vector<Flow>& flows);

  /// Everything that is connected to an entity, itself included.
  std::set<EntityId> reachable(const EntityId& from) const;

  /// The steps of a shortest path between two entities, in its order. Empty: they are not connected.
  std::vector<FlowStep> path(const EntityId& from, const EntityId& to) const;

 private:
  struct Edge {
    EntityId to;
    const Flow* flow;
  };
  const std::vector<Edge>& edges_of(const EntityId& entity) const;

  std::map<EntityId, std::vector<Edge>> edges_;
};

}  // namespace tzc::rewriter
