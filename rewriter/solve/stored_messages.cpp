// SPDX-License-Identifier: BSD-3-Clause
#include "solve/stored_messages.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <variant>

namespace tzc::rewriter {
namespace {

/// What is published alone, and all that may be the same message. None: nothing in the component is an array of its messages.
std::set<EntityId> published_alone(const Facts& facts, const Components& components,
                                   const Component& component) {
  std::set<EntityId> found;
  bool has_arrays = false;
  for (const auto& item : facts.publishes)
    for (const EntityId& message : item.second.messages) {
      const Component* of = components.of(message);
      if (!of || of->id != component.id) continue;
      has_arrays = has_arrays || item.second.nested_only;
      if (!item.second.nested_only) found.insert(message);
    }
  if (!has_arrays) return {};
  const auto type_of = [&](const EntityId& id) { return facts.entities.at(id).type; };
  for (std::size_t known = 0; known != found.size();) {
    known = found.size();
    for (const Flow& flow : facts.flows)
      if (found.count(flow.to) != 0 && facts.entities.count(flow.from) != 0 &&
          type_of(flow.from) == type_of(flow.to))
        found.insert(flow.from);
  }
  return found;
}

/// Without the edits it would be made from a stock message.
bool starts_as_copy(const AllocationSite& site) {
  const auto* inserted = std::get_if<InsertedAllocation>(&site.how);
  return !inserted || inserted->filled;
}

}  // namespace

std::vector<const AllocationSite*> without_stored(const Facts& facts, const Components& components,
                                                  const Component& component,
                                                  const std::vector<const AllocationSite*>& sites) {
  const std::set<EntityId> alone = published_alone(facts, components, component);
  std::vector<const AllocationSite*> found;
  std::copy_if(sites.begin(), sites.end(), std::back_inserter(found), [&](const AllocationSite* site) {
    return alone.empty() || alone.count(site->entity) != 0 || starts_as_copy(*site);
  });
  return found;
}

}  // namespace tzc::rewriter
