// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/codes.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// Components that must not be ported after verification, and why.
using Demotions = std::map<ComponentId, Obstacle>;

/// not_needed: no array of it is ever filled, or its messages have no data part.
enum class Outcome { ported, refused, not_needed };

/// What happens to a component.
struct Decision {
  Outcome outcome = Outcome::not_needed;
  Obstacle why_not;  ///< of one that is not ported
  EntityId at;       ///< the entity that has the obstacle; empty: none of them
};

inline Decision refused(Obstacle why_not, EntityId at = {}) {
  return {Outcome::refused, std::move(why_not), std::move(at)};
}

inline Decision not_needed(std::string reason) {
  return {Outcome::not_needed, {"", std::move(reason), {}}, {}};
}

/// Whether the user said that it is to stay.
inline bool is_left_out(const Decision& decision) {
  return decision.why_not.code == codes::TZC1015 || decision.why_not.code == codes::TZC1016;
}

/// An allocation site, with the publisher that allocates there.
struct BoundAllocation {
  const AllocationSite* site;
  std::string publisher;           ///< expression: "pub_", "*pub"
  std::vector<std::string> calls;  ///< "pub_.allocate"; of pointers that may be null, one after the other
  const Entity* entity = nullptr;  ///< the publisher; null: the factory's own parameter, or none
  bool is_of_node = false;         ///< memory of the node, if no publisher can be named or none is there
};

/// A factory that is given the publisher.
struct GivenPublisher {
  EntityId factory;  ///< its result
  EntityId message;  ///< that it makes
  PortedClass type;
};

/// What is ported, how, and why not further.
struct Solution {
  std::map<ComponentId, Decision> decisions;  ///< messages that are not published have none
  std::vector<BoundAllocation> allocations;
  std::vector<GivenPublisher> factories;

  /// Null: there is none.
  const Decision* of(ComponentId component) const {
    const auto found = decisions.find(component);
    return found == decisions.end() ? nullptr : &found->second;
  }
  bool ports(ComponentId component) const {
    const Decision* decision = of(component);
    return decision && decision->outcome == Outcome::ported;
  }
};

}  // namespace tzc::rewriter
