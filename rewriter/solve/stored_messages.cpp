// SPDX-License-Identifier: BSD-3-Clause
#include "solve/stored_messages.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <variant>

namespace tzc::rewriter {
namespace {

/// What is published alone, and all that may be the same message. None: nothing in the component is an array of its messages.
std::set<EntityId> published_alone(const Facts& facts, const SiteIndex::Sites<Publish>& publishes) {
  std::set<EntityId> found;
  for (const Publish* publish : publishes)
    if (!publish->nested_only) found.insert(publish->messages.begin(), publish->messages.end());
  const auto is_nested = [](const Publish* publish) { return publish->nested_only; };
  if (std::none_of(publishes.begin(), publishes.end(), is_nested)) return {};
  const auto type_of = [&](const EntityId& id) {
    const auto entity = facts.entities.find(id);
    return entity == facts.entities.end() ? std::string() : entity->second.type;
  };
  for (std::size_t known = 0; known != found.size();) {
    known = found.size();
    for (const Flow& flow : facts.flows)
      if (found.count(flow.to) != 0 && type_of(flow.from) == type_of(flow.to)) found.insert(flow.from);
  }
  return found;
}

/// Without the edits it would be made from a stock message.
bool starts_as_copy(const AllocationSite& site) {
  const auto* inserted = std::get_if<InsertedAllocation>(&site.how);
  return !inserted || inserted->filled;
}

}  // namespace

SiteIndex::Sites<AllocationSite> without_stored(const Facts& facts, const SiteIndex& sites,
                                                const Component& component) {
  const SiteIndex::Sites<AllocationSite>& all = sites.allocations(component);
  const std::set<EntityId> alone = published_alone(facts, sites.publishes_of(component));
  if (alone.empty()) return all;
  SiteIndex::Sites<AllocationSite> found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found), [&](const AllocationSite* site) {
    return alone.count(site->entity) != 0 || starts_as_copy(*site);
  });
  return found;
}

}  // namespace tzc::rewriter
