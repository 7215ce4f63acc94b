// SPDX-License-Identifier: BSD-3-Clause
#include "solve/solution.h"

#include <algorithm>

#include "report/codes.h"
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
  bool shape_allows(const Component& component, Solution::Message& message) const;
  bool bind_births(const Component& component, Solution::Message& message);
  std::optional<Solution::Bound> bind(const Birth& birth, const std::set<int>& publishers) const;
  bool visible(const Birth& birth, const Entity& publisher) const;
  bool all_local(const Component& component) const;
  bool inherits(const std::string& record, const std::string& base) const;

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
  publisher.ported = true;
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

bool Solver::inherits(const std::string& record, const std::string& base) const {
  if (record.empty() || base.empty()) return false;
  if (record == base) return true;
  const auto bases = facts_.bases.find(record);
  return bases != facts_.bases.end() && std::any_of(bases->second.begin(), bases->second.end(),
                                                    [&](const std::string& b) { return inherits(b, base); });
}

bool Solver::visible(const Birth& birth, const Entity& publisher) const {
  if (publisher.home == Home::member) return inherits(birth.record, publisher.record);
  return publisher.home == Home::global && publisher.where.file == birth.where.file &&
         publisher.where.line < birth.where.line;
}

std::optional<Solution::Bound> Solver::bind(const Birth& birth, const std::set<int>& publishers) const {
  const auto bound = [&](const std::string& text, bool pointer) {
    return Solution::Bound{&birth, pointer ? "*" + text : text, text + (pointer ? "->" : ".") + "allocate"};
  };
  // First one that is named together with this very message.
  for (const bool together : {true, false})
    for (const PublisherName& name : birth.publishers) {
      const Component* publisher = components_.of(name.publisher);
      const bool with_it = std::count(name.messages.begin(), name.messages.end(), birth.entity) != 0;
      if (publisher && publishers.count(publisher->id) && (with_it || !together))
        return bound(name.text, name.pointer);
    }
  for (const int id : publishers)
    for (const Entity* entity : components_.all()[static_cast<std::size_t>(id)].entities)
      if (visible(birth, *entity) && entity->plain) return bound(entity->name, false);
  return {};
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
  std::vector<Solution::Bound> births;
  for (const Birth* birth : births_[component.id]) {
    const auto bound = bind(*birth, publishers);
    if (!bound || birth->filled || (!birth->adapter && !birth->at)) {
      message.why_not = {birth->filled ? codes::TZC1020 : codes::TZC1019,
                         birth->filled ? "it starts as a copy of another message"
                                       : "it is built where its publisher can not be named",
                         birth->where};
      message.at = birth->entity;
      return false;
    }
    births.push_back(*bound);
  }
  if (births.empty()) {
    message.why_not = {codes::TZC1019, "where it is built was not found", component.entities[0]->where};
    return false;
  }
  solution_.births.insert(solution_.births.end(), births.begin(), births.end());
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
