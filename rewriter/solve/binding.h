// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>

#include "solve/components.h"
#include "solve/locks.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// The publishers that send a message.
struct Senders {
  std::set<ComponentId> ported;
  bool has_kept = false;  ///< also one that keeps its class, and gives no memory
};

/// Finds, for each allocation site of a message component, a publisher that is available there.
class Binder {
 public:
  Binder(const Facts& facts, const Components& components, const Component& component, Senders senders)
      : facts_(facts),
        components_(components),
        component_(component),
        locks_(facts),
        senders_(std::move(senders)) {}

  /// Why a site has none; nothing: each has one.
  std::optional<Decision> bind(const std::vector<const AllocationSite*>& sites);

  const std::vector<BoundAllocation>& allocations() const { return allocations_; }
  /// Functions that are given the publisher, because they allocate the message.
  const std::vector<GivenPublisher>& factories() const { return factories_; }

 private:
  void bind_all(const std::vector<const AllocationSite*>& sites);
  bool goes_without(const AllocationSite& site) const;
  bool is_published(const EntityId& message) const;
  std::optional<Decision> obstacle_at(const AllocationSite& site) const;
  void bind(const AllocationSite& site);
  void give_publishers();
  bool is_in_factory(const AllocationSite& site) const;
  int closeness(const PublisherName& name, const AllocationSite& site) const;
  bool is_nameable(const PublisherName& name, const AllocationSite& site);
  std::optional<BoundAllocation> named_at(const AllocationSite& site, int wanted);
  std::optional<BoundAllocation> available_at(const AllocationSite& site);
  bool may_wait(const PublisherName& name);
  bool may_change_under_lock(ComponentId publisher) const;
  bool may_be_missing(const AllocationSite& site, const Entity& publisher);
  bool visible(const AllocationSite& site, const Entity& publisher);
  bool runs_early(const std::string& function);

  const Facts& facts_;
  const Components& components_;
  const Component& component_;
  Locks locks_;
  Senders senders_;
  std::optional<std::set<std::string>> early_;
  std::set<EntityId> given_;      // results of factories
  bool lacks_publisher_ = false;  // at a site, none can be named
  bool by_node_ = false;          // where none can be named, memory of the node will do
  std::vector<BoundAllocation> allocations_;
  std::vector<GivenPublisher> factories_;
};

}  // namespace tzc::rewriter
