// SPDX-License-Identifier: BSD-3-Clause
#include "solve/attached_topics.h"

#include <algorithm>

#include "solve/light_messages.h"

namespace tzc::rewriter {

bool AttachedTopics::ports_call(const SiteId& site) const {
  const Component* call = components_.of(site);
  return call && solution_.ports(call->id);
}

bool AttachedTopics::attaches(const Publish& site) const {
  return site.attaching.is_done || ports_call(site.id());
}

bool AttachedTopics::is_attached(const Advertise& site) const {
  return site.attaching.is_done || ports_call(site.id());
}

bool AttachedTopics::is_attached_by_calls(const EntityId& publisher) const {
  const Component* component = components_.of(publisher);
  if (!component) return false;
  std::size_t attaching = 0;
  for (const Publish* site : sites_.published_by(*component)) {
    if (attaches(*site))
      ++attaching;
    else if (!publishes_light_message(*site, components_, solution_))
      return false;
  }
  return attaching != 0;
}

bool AttachedTopics::reach(const EntityId& publisher) const {
  const Component* component = components_.of(publisher);
  if (!component) return false;
  if (solution_.ports(component->id)) return true;
  const auto& sites = sites_.advertised(*component);
  const bool any =
      std::any_of(sites.begin(), sites.end(), [&](const Advertise* site) { return is_attached(*site); });
  return any && std::all_of(sites.begin(), sites.end(), [&](const Advertise* site) {
           return !site->has_data_part || is_attached(*site);
         });
}

bool AttachedTopics::reach_made_by_library(const std::string& library_class) const {
  bool any = false;
  for (const auto& [id, site] : facts_.advertises) {
    if (site.library_class != library_class) continue;
    if (!is_attached(site)) return false;
    any = true;
  }
  return any;
}

bool AttachedTopics::reach_class(const std::string& library_class) const {
  if (library_class.empty()) return false;
  if (reach_made_by_library(library_class)) return true;
  const auto given = facts_.library_publishers.find(library_class);
  return given != facts_.library_publishers.end() &&
         std::all_of(given->second.begin(), given->second.end(),
                     [&](const EntityId& publisher) { return reach(publisher); });
}

}  // namespace tzc::rewriter
