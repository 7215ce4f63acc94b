// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>

#include "model/facts.h"
#include "solve/components.h"
#include "solve/concurrent_reads.h"

namespace tzc::rewriter {

/// Whether a pointer into the data of a component's messages may live across one of its publishes, by the same thread or by another, or code
/// that knows the stock type alone may find one of the messages.
class Soundness {
 public:
  Soundness(const Facts& facts, const Components& components)
      : facts_(facts), components_(components), concurrent_(facts, components) {}

  struct Danger {
    Obstacle why;
    EntityId at;
  };
  /// None: each pointer is known to be gone, or to be harmless.
  std::optional<Danger> danger(const Component& component);

 private:
  bool is_in(const EntityId& key) const;
  bool any_in(const std::set<EntityId>& keys) const;
  bool outlives_scope(const Component& component) const;
  /// What a function may do to a message of the component; writes: publish or write.
  enum class Reach { publishes, writes };
  bool concerns(const PublishEvent& event, Reach reach);
  bool may_reach(const std::string& function, Reach reach);
  const std::set<std::string>& reaching(Reach reach);
  bool ends_loudly();
  const ConstCast* cast_to(const Component& component) const;

  const Facts& facts_;
  const Components& components_;
  ConcurrentReads concurrent_;
  const Component* component_ = nullptr;
  bool lasting_ = false;
  std::optional<std::set<std::string>> publishing_, writing_;  // functions, for component_
};

}  // namespace tzc::rewriter
