// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pending_sites.h"

#include <algorithm>
#include <set>
#include <tuple>

namespace tzc::rewriter {
namespace {

using SitePlace = std::tuple<SiteKind, std::string, unsigned, unsigned, std::string>;

class PendingPlaces {
 public:
  PendingPlaces(const Components& components, const Edits& edits) : components_(components) {
    for (const Edit& edit : edits)
      if (edit.component) edited_.insert(*edit.component);
  }

  std::set<SitePlace> run(const Facts& facts) const {
    std::set<SitePlace> places;
    for (const auto& item : facts.advertises)
      if (is_edited(item.second.publisher) || is_edited(components_.of(item.first)))
        places.insert(place_of(SiteKind::advertise, item.second));
    for (const auto& item : facts.publishes)
      if (is_edited(item.second) || is_edited(components_.of(item.first)) || is_attached(facts, item.second))
        places.insert(place_of(SiteKind::publish, item.second));
    for (const auto& item : facts.subscribes)
      if (is_edited(components_.of(item.first)) || is_edited(item.second.filter))
        places.insert(place_of(SiteKind::subscribe, item.second));
    return places;
  }

 private:
  static SitePlace place_of(SiteKind kind, const SiteFact& fact) {
    return {kind, fact.where.file, fact.where.line, fact.where.column, fact.type};
  }
  bool is_edited(const Component* component) const { return component && edited_.count(component->id) != 0; }
  bool is_edited(const EntityId& entity) const { return is_edited(components_.of(entity)); }
  /// Whether an advertise call that is changed attaches its topic.
  bool is_attached(const Facts& facts, const Publish& site) const {
    return std::any_of(facts.advertises.begin(), facts.advertises.end(), [&](const auto& item) {
      const Advertise& advertise = item.second;
      if (!is_edited(components_.of(item.first))) return false;
      if (advertise.publisher.empty())
        return !site.library_class.empty() && advertise.library_class == site.library_class;
      return is_of(advertise.publisher, site.publisher) ||
             (!site.library_class.empty() && is_given(facts, advertise.publisher, site.library_class));
    });
  }
  bool is_given(const Facts& facts, const EntityId& publisher, const std::string& library_class) const {
    const auto given = facts.library_publishers.find(library_class);
    return given != facts.library_publishers.end() &&
           std::any_of(given->second.begin(), given->second.end(),
                       [&](const EntityId& one) { return is_of(publisher, one); });
  }
  bool is_of(const EntityId& one, const EntityId& other) const {
    const Component* component = components_.of(one);
    return component && component == components_.of(other);
  }
  bool is_edited(const Publish& fact) const {
    if (is_edited(fact.publisher)) return true;
    for (const EntityId& message : fact.messages)
      if (is_edited(message)) return true;
    return false;
  }

  const Components& components_;
  std::set<ComponentId> edited_;
};

bool is_ported(const Site& site) {
  return site.level != Level::plain && site.level != Level::not_needed;
}

}  // namespace

void mark_pending(std::vector<Site>& sites, const Facts& facts, const Components& components,
                  const Edits& edits) {
  const std::set<SitePlace> pending = PendingPlaces(components, edits).run(facts);
  for (Site& site : sites)
    site.pending = is_ported(site) && pending.count({site.kind, site.where.file, site.where.line,
                                                     site.where.column, site.message_type}) != 0;
}

}  // namespace tzc::rewriter
