// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "facts/facts.h"

namespace tzc::rewriter {

/// Entities that must be ported together: connected by flow, or declared by one type.
struct Component {
  int id = 0;
  Carrier carrier = Carrier::message;
  std::vector<const Entity*> entities;  ///< in the order of their keys
  std::string name;                     ///< stable over runs on the same sources
};

/// The flow graph, partitioned.
class Components {
 public:
  /// `all_or_nothing` false, for tests: every entity on its own.
  explicit Components(const Facts& facts, bool all_or_nothing = true);

  /// Null: nothing is known under this key.
  const Component* of(const Key& key) const;
  const std::vector<Component>& all() const { return components_; }

 private:
  std::vector<Component> components_;
  std::map<Key, std::size_t> index_;
};

/// What flows into or out of each entity.
using Neighbours = std::map<Key, std::vector<Key>>;
Neighbours flow_neighbours(const Facts& facts);
std::set<Key> reachable(const Neighbours& neighbours, const Key& from);

/// The steps of flow between two entities, shortest way; empty: none.
std::vector<FlowStep> chain_between(const Facts& facts, const Key& from, const Key& to);

}  // namespace tzc::rewriter
