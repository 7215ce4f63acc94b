// SPDX-License-Identifier: BSD-3-Clause
#include "solve/kept_publishers.h"

#include <algorithm>

#include "model/codes.h"
#include "solve/light_messages.h"
#include "solve/site_of_fact.h"

namespace tzc::rewriter {

KeptPublishers::KeptPublishers(const Facts& facts, const Components& components, const SolveOptions& options,
                               const Solution& solution)
    : facts_(facts),
      components_(components),
      options_(options),
      solution_(solution),
      sites_(facts, components),
      flow_graph_(facts.flows) {}

/// Nothing in the package advertises it.
bool KeptPublishers::is_of_other_code(const EntityId& publisher) const {
  const Component* component = components_.of(publisher);
  const Decision* decision = component ? solution_.of(component->id) : nullptr;
  return !component ||
         (decision && decision->outcome == Outcome::refused && decision->why_not.code == codes::TZC1017);
}

bool KeptPublishers::is_kept(const EntityId& publisher) const {
  const Component* component = components_.of(publisher);
  const Decision* decision = component ? solution_.of(component->id) : nullptr;
  return !component || (decision && decision->outcome == Outcome::refused && !is_left_out(*decision));
}

/// Why the call stays as it is.
std::optional<Decision> KeptPublishers::obstacle_at(const Component& call) const {
  const Publish& site = *call.publish_call;
  const Location here = location_of(site.where);
  for (const Obstacle& obstacle : site.obstacles)
    if (obstacle.code == codes::TZC1012 || obstacle.code == codes::TZC1014) return refused(obstacle);
  if (options_.max_level == Level::plain)
    return refused({codes::TZC1015, "this run leaves everything on TCPROS", here});
  Site described = site_of(site, options_.packages);
  described.topic = topic_of(facts_, flow_graph_, site.publisher);
  if (options_.wanted && !options_.wanted(described))
    return refused({codes::TZC1016, "left out by --only or --except", here});
  return {};
}

bool KeptPublishers::take_ported_message(const Publish& site) const {
  if (!is_kept(site.publisher)) return false;
  const Component* call = components_.of(site.id());
  return site.attaching.is_done || (call && !obstacle_at(*call));
}

bool KeptPublishers::publishes_ported_message(const Publish& site) const {
  return std::any_of(site.messages.begin(), site.messages.end(), [&](const EntityId& message) {
    const Component* component = components_.of(message);
    return component && solution_.ports(component->id);
  });
}

Decision KeptPublishers::decide_publish_call(const Component& call) const {
  const Publish& site = *call.publish_call;
  if (publishes_light_message(site, components_, solution_)) return {};
  const bool is_wanted =
      is_of_other_code(site.publisher) || (is_kept(site.publisher) && publishes_ported_message(site));
  if (!is_wanted) return {};
  return obstacle_at(call).value_or(Decision{Outcome::ported, {}, {}});
}

/// Nothing is known of what is published with one that leaves the package.
bool KeptPublishers::needs_memory_beside_calls(const Component& publisher) const {
  if (is_given_away(publisher)) return true;
  const auto& sites = sites_.published_by(publisher);
  return sites.empty() || std::any_of(sites.begin(), sites.end(), [&](const Publish* site) {
           const Component* call = components_.of(site->id());
           return !site->attaching.is_done && !(call && solution_.ports(call->id)) &&
                  !publishes_light_message(*site, components_, solution_);
         });
}

bool KeptPublishers::needs_memory(const Advertise& site) const {
  if (!site.has_data_part) return false;
  const Component* publisher = components_.of(site.publisher);
  const bool is_wanted = !options_.wanted || options_.wanted(site_of(site, options_.packages));
  if (!site.library_class.empty()) return is_wanted && options_.max_level != Level::plain;
  return is_wanted && publisher && is_kept(site.publisher) && needs_memory_beside_calls(*publisher);
}

Decision KeptPublishers::decide_advertise_call(const Component& call) const {
  const Place& here = call.advertise_call->where;
  if (!needs_memory(*call.advertise_call)) return {};
  // Instances of a template share the call: either all of them change it, and alike, or none. What is light is the same with it.
  const std::string& text = call.advertise_call->attaching.changes.front().text;
  const bool all_alike =
      std::all_of(facts_.advertises.begin(), facts_.advertises.end(), [&](const auto& item) {
        const Advertise& site = item.second;
        if (site.where.file != here.file || site.where.begin != here.begin || !site.has_data_part)
          return true;
        const std::vector<Change>& changes = site.attaching.changes;
        return needs_memory(site) && !changes.empty() && changes.front().text == text;
      });
  if (!all_alike) return {};
  return {Outcome::ported, {}, {}};
}

}  // namespace tzc::rewriter
