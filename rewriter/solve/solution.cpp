// SPDX-License-Identifier: BSD-3-Clause
#include "solve/solution.h"

#include <algorithm>
#include <tuple>

#include "report/codes.h"
#include "solve/binding.h"
#include "solve/sites.h"

namespace tzc::rewriter {
namespace {

class Solver {
 public:
  Solver(const Facts& facts, const Components& components, const EngineOptions& options,
         const Demotions& demotions)
      : facts_(facts), components_(components), options_(options), demotions_(demotions) {}

  Solution run() {
    neighbours_ = flow_neighbours(facts_);
    index_sites();
    for (const Component& component : components_.all()) {
      if (component.carrier == Carrier::publisher) solve_publisher(component);
      if (component.carrier == Carrier::filter) solve_filter(component);
    }
    for (const Component& component : components_.all())
      if (component.carrier == Carrier::message) solve_message(component);
    leave_idle_publishers();
    return std::move(solution_);
  }

 private:
  void index_sites();
  void solve_publisher(const Component& component);
  void solve_filter(const Component& component);
  void solve_message(const Component& component);
  void leave_idle_publishers();
  bool blocked(const Component& component, Obstacle& why, Key& at) const;
  bool unwanted(const Component& component, Obstacle& why) const;
  bool contradicted(const Component& component, Obstacle& why) const;
  bool shape_allows(const Component& component, Solution::Message& message) const;
  bool bind_births(const Component& component, Solution::Message& message);
  bool all_local(const Component& component) const;

  const Facts& facts_;
  const Components& components_;
  const EngineOptions& options_;
  const Demotions& demotions_;
  Solution solution_;
  std::map<int, std::vector<const Publish*>> published_by_, publishes_of_;
  std::map<int, std::vector<const Advertise*>> advertised_;
  std::map<int, std::vector<const Birth*>> births_;
  std::set<int> filled_;
  Neighbours neighbours_;
};

void Solver::index_sites() {
  for (const auto& item : facts_.publishes) {
    const Publish& site = item.second;
    if (const Component* publisher = components_.of(site.publisher))
      published_by_[publisher->id].push_back(&site);
    for (const Key& key : site.messages)
      if (const Component* message = components_.of(key)) {
        auto& sites = publishes_of_[message->id];
        if (std::find(sites.begin(), sites.end(), &site) == sites.end()) sites.push_back(&site);
      }
  }
  for (const auto& item : facts_.advertises)
    if (const Component* publisher = components_.of(item.second.publisher))
      advertised_[publisher->id].push_back(&item.second);
  for (const Birth& birth : facts_.births)
    if (const Component* message = components_.of(birth.entity)) births_[message->id].push_back(&birth);
  for (const DataUse& use : facts_.data_uses)
    if (const Component* message = components_.of(use.entity)) filled_.insert(message->id);
}

bool Solver::blocked(const Component& component, Obstacle& why, Key& at) const {
  for (const Entity* entity : component.entities)
    if (!entity->obstacles.empty() && !entity->ported) {
      why = entity->obstacles.front();
      at = entity->key;
      return true;
    }
  const auto demoted = demotions_.find(component.name);
  if (demoted == demotions_.end()) return false;
  why = demoted->second;
  at = component.name;
  return true;
}

bool Solver::unwanted(const Component& component, Obstacle& why) const {
  if (!options_.wanted) return false;
  const auto leave = [&](const Site& site) {
    if (options_.wanted(site)) return false;
    why = {codes::TZC1016, "left out by --only or --except", site.where};
    return true;
  };
  const auto publishes = published_by_.find(component.id);
  if (publishes != published_by_.end())
    for (const Publish* fact : publishes->second) {
      Site site = described(*fact, SiteKind::publish, options_.package_dir);
      site.topic = topic_of(facts_, neighbours_, fact->publisher);
      if (leave(site)) return true;
    }
  const auto advertises = advertised_.find(component.id);
  if (advertises == advertised_.end()) return false;
  return std::any_of(advertises->second.begin(), advertises->second.end(), [&](const Advertise* fact) {
    return leave(described(*fact, SiteKind::advertise, options_.package_dir));
  });
}

/// By an earlier run, or by hand.
bool is_ported_already(const Component& component) {
  return std::all_of(component.entities.begin(), component.entities.end(),
                     [](const Entity* entity) { return entity->ported; });
}

void Solver::solve_publisher(const Component& component) {
  Solution::Publisher& publisher = solution_.publishers[component.id];
  const bool heavy = std::any_of(published_by_[component.id].begin(), published_by_[component.id].end(),
                                 [](const Publish* p) { return p->heavy || p->pcl; }) ||
                     std::any_of(advertised_[component.id].begin(), advertised_[component.id].end(),
                                 [](const Advertise* a) { return a->heavy; });
  if (!heavy) return;
  if (is_ported_already(component)) {
    publisher.ported = true;
    return;
  }
  if (options_.max_level == Level::plain) {
    publisher.why_not = {codes::TZC1015, "this run leaves everything on TCPROS",
                         component.entities[0]->where};
    return;
  }
  if (blocked(component, publisher.why_not, publisher.at) || unwanted(component, publisher.why_not)) return;
  if (advertised_[component.id].empty()) {
    publisher.why_not = {
        codes::TZC1017,
        "no advertise call for '" + component.entities[0]->name + "' was found in the package",
        component.entities[0]->where};
    return;
  }
  if (contradicted(component, publisher.why_not)) return;
  publisher.ported = true;
}

/// One advertise call of a template that each instance would need changed differently.
bool Solver::contradicted(const Component& component, Obstacle& why) const {
  std::map<std::tuple<std::string, unsigned, unsigned>, std::string> texts;
  for (const Advertise* site : advertised_.at(component.id))
    for (const Change& change : site->changes) {
      const auto [known, is_new] = texts.emplace(
          std::make_tuple(change.where.file, change.where.begin, change.where.end), change.text);
      if (is_new || known->second == change.text) continue;
      why = {codes::TZC1007, "the instances of a template advertise different types here",
             location_of(site->where)};
      return true;
    }
  return false;
}

void Solver::solve_filter(const Component& component) {
  Solution::Publisher& filter = solution_.filters[component.id];
  filter.ported = !blocked(component, filter.why_not, filter.at);
}

/// A publisher all of whose messages are empty stays as it is.
void Solver::leave_idle_publishers() {
  for (auto& [id, publisher] : solution_.publishers) {
    const std::vector<const Publish*>& sites = published_by_[id];
    const bool idle = !sites.empty() && std::all_of(sites.begin(), sites.end(), [&](const Publish* site) {
      const Component* message = site->messages.empty() ? nullptr : components_.of(site->messages[0]);
      return message && solution_.messages[message->id].empty;
    });
    if (idle) publisher.ported = false;
  }
}

bool Solver::shape_allows(const Component& component, Solution::Message& message) const {
  const auto sites = publishes_of_.find(component.id);
  if (sites == publishes_of_.end()) return false;
  const auto nested = std::find_if(sites->second.begin(), sites->second.end(),
                                   [](const Publish* site) { return site->nested_only; });
  if (nested != sites->second.end()) {
    message.why_not = {codes::TZC1018, "its arrays lie inside an array of messages",
                       location_of((*nested)->where)};
    return false;
  }
  if (options_.max_level != Level::zero_copy) {
    message.why_not = {codes::TZC1015, "this run goes no further than one_copy",
                       location_of(sites->second.front()->where)};
    return false;
  }
  return true;
}

void Solver::solve_message(const Component& component) {
  const auto sites = publishes_of_.find(component.id);
  if (sites == publishes_of_.end()) return;
  Solution::Message& message = solution_.messages[component.id];
  const bool is_blocked = blocked(component, message.why_not, message.at);
  if (!is_blocked && filled_.count(component.id) == 0 && all_local(component)) {
    message.empty = true;
    return;
  }
  if (is_blocked || !shape_allows(component, message)) return;
  message.ported = bind_births(component, message);
}

/// Born here and nowhere else: what is not seen to be filled is empty.
bool Solver::all_local(const Component& component) const {
  const auto births = births_.find(component.id);
  if (births == births_.end()) return false;
  return std::none_of(births->second.begin(), births->second.end(),
                      [](const Birth* b) { return b->filled; }) &&
         std::all_of(component.entities.begin(), component.entities.end(), [](const Entity* entity) {
           return entity->home == Home::local || entity->home == Home::temporary;
         });
}

bool Solver::bind_births(const Component& component, Solution::Message& message) {
  std::set<int> publishers;
  for (const Publish* site : publishes_of_[component.id])
    if (const Component* publisher = components_.of(site->publisher))
      if (solution_.publishers[publisher->id].ported) publishers.insert(publisher->id);
  if (publishers.empty()) {
    message.why_not = {codes::TZC1009, "its publisher stays on TCPROS", component.entities[0]->where};
    return false;
  }
  Binder binder(facts_, components_, component, std::move(publishers));
  if (!binder.bind(births_[component.id], message)) return false;
  solution_.births.insert(solution_.births.end(), binder.births().begin(), binder.births().end());
  solution_.helpers.insert(solution_.helpers.end(), binder.helpers().begin(), binder.helpers().end());
  return true;
}

}  // namespace

Solution solve(const Facts& facts, const Components& components, const EngineOptions& options,
               const Demotions& demotions) {
  Solution solution = Solver(facts, components, options, demotions).run();
  solution.sites = decided_sites(facts, components, options, demotions, solution);
  return solution;
}

}  // namespace tzc::rewriter
