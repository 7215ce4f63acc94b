// SPDX-License-Identifier: BSD-3-Clause
#include "solve/site_index.h"

#include <algorithm>

namespace tzc::rewriter {

SiteIndex::SiteIndex(const Facts& facts, const Components& components) {
  for (const auto& item : facts.publishes) {
    const Publish& site = item.second;
    if (const Component* publisher = components.of(site.publisher))
      published_by_[publisher->id].push_back(&site);
    for (const EntityId& entity : site.messages)
      if (const Component* message = components.of(entity)) {
        auto& sites = publishes_of_[message->id];
        if (std::find(sites.begin(), sites.end(), &site) == sites.end()) sites.push_back(&site);
      }
  }
  for (const auto& item : facts.advertises)
    if (const Component* publisher = components.of(item.second.publisher))
      advertised_[publisher->id].push_back(&item.second);
  for (const AllocationSite& site : facts.allocations)
    if (const Component* message = components.of(site.entity)) allocations_[message->id].push_back(&site);
}

template <class Fact>
const SiteIndex::Sites<Fact>& SiteIndex::at(const ByComponent<Fact>& sites, const Component& component) {
  static const Sites<Fact> none;
  const auto found = sites.find(component.id);
  return found == sites.end() ? none : found->second;
}

const SiteIndex::Sites<Publish>& SiteIndex::published_by(const Component& publisher) const {
  return at(published_by_, publisher);
}

const SiteIndex::Sites<Publish>& SiteIndex::publishes_of(const Component& message) const {
  return at(publishes_of_, message);
}

const SiteIndex::Sites<Advertise>& SiteIndex::advertised(const Component& publisher) const {
  return at(advertised_, publisher);
}

const SiteIndex::Sites<AllocationSite>& SiteIndex::allocations(const Component& message) const {
  return at(allocations_, message);
}

}  // namespace tzc::rewriter
