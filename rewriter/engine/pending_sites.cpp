// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pending_sites.h"

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
      if (is_edited(item.second.publisher)) places.insert(place_of(SiteKind::advertise, item.second));
    for (const auto& item : facts.publishes)
      if (is_edited(item.second) || is_edited(components_.of(item.first)))
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
