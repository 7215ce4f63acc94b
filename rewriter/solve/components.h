// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <vector>

#include "model/facts.h"

namespace tzc::rewriter {

enum class ComponentKind { message, publisher, filter, subscription, publish_call, advertise_call };

/// Is ported as a whole or not at all: entities that flows connect or that one type declares, one subscription, or one call that
/// can publish or advertise with a publisher that keeps its class.
struct Component {
  ComponentId id{};
  ComponentKind kind = ComponentKind::message;
  std::vector<const Entity*> entities;        ///< in the order of their ids; none: a subscription or a call
  const Subscribe* subscription = nullptr;    ///< null: something else
  const Publish* publish_call = nullptr;      ///< null: something else
  const Advertise* advertise_call = nullptr;  ///< null: something else
  bool has_lasting_start = false;             ///< a lasting pointer starts with one of its messages

  /// One that no function makes, or that a lasting pointer starts with. Its first publish binds it to the publisher's memory.
  bool has_lasting_message() const;
};

/// Whether code outside the package has the publisher (TZC1010), and may publish with it.
bool is_given_away(const Component& publisher);

/// Variables that can part from those declared in front of them, because the whole declaration can be cut.
std::set<EntityId> separable(const Facts& facts);

/// The partition of the flow graph, the subscriptions and the calls into components. The facts must outlive it.
class Components {
 public:
  /// `all_or_nothing` false, for tests: every entity on its own.
  explicit Components(const Facts& facts, bool all_or_nothing = true);

  /// Null: nothing is known under this id.
  const Component* of(const EntityId& entity) const;
  const Component* of(const SiteId& site) const;
  const Component& operator[](ComponentId id) const { return components_.at(static_cast<std::size_t>(id)); }
  const std::vector<Component>& all() const { return components_; }

 private:
  Component& add(ComponentKind kind);
  void add_entities(const Facts& facts, bool all_or_nothing);

  std::vector<Component> components_;
  std::map<EntityId, ComponentId> of_entity_;
  std::map<SiteId, ComponentId> of_site_;
};

}  // namespace tzc::rewriter
