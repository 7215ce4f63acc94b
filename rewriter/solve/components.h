// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
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
  explicit Components(const Facts& facts);

  /// Null: nothing is known under this key.
  const Component* of(const Key& key) const;
  const std::vector<Component>& all() const { return components_; }

 private:
  std::vector<Component> components_;
  std::map<Key, std::size_t> index_;
};

/// The steps of flow between two entities, shortest way; empty: none.
std::vector<FlowStep> chain_between(const Facts& facts, const Key& from, const Key& to);

}  // namespace tzc::rewriter
