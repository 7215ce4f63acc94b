// SPDX-License-Identifier: BSD-3-Clause
#include "solve/components.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/codes.h"

namespace tzc::rewriter {
namespace {

class UnionFind {
 public:
  explicit UnionFind(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t find(std::size_t item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void unite(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

using Numbers = std::map<EntityId, std::size_t>;

bool same_role(const Facts& facts, const EntityId& a, const EntityId& b) {
  return facts.entities.at(a).role == facts.entities.at(b).role;
}

void unite_flows(const Facts& facts, const Numbers& numbers, UnionFind& sets) {
  for (const Flow& flow : facts.flows) {
    const auto from = numbers.find(flow.from), to = numbers.find(flow.to);
    if (!flow.copies && from != numbers.end() && to != numbers.end() && same_role(facts, flow.from, flow.to))
      sets.unite(from->second, to->second);
  }
}

/// Which copies of messages have to be ported together with what they are made of. A ported message can be assigned a stock one,
/// not the reverse: so the two are separate where the original stays a stock one for certain, because something stands against it, or
/// because nothing publishes it or copies a ported one into it. They are, too, where the copy stays one for certain, because something
/// stands against that, and the port can make a stock message of what is copied.
class Copies {
 public:
  Copies(const Facts& facts, const Numbers& numbers, UnionFind& sets) : sets_(sets) {
    for (const Flow& flow : facts.flows) {
      const auto from = numbers.find(flow.from), to = numbers.find(flow.to);
      if (!flow.copies || from == numbers.end() || to == numbers.end()) continue;
      bool& can_convert =
          copies_.emplace(std::make_pair(sets.find(from->second), sets.find(to->second)), true).first->second;
      can_convert = can_convert && !flow.as_stock.empty();
    }
    for (const auto& [id, entity] : facts.entities)
      if (!entity.obstacles.empty() && !entity.ported) stock_.insert(sets.find(numbers.at(id)));
    for (const auto& item : facts.publishes)
      for (const EntityId& message : item.second.messages)
        if (const auto number = numbers.find(message); number != numbers.end())
          reach(sets.find(number->second));
  }

  void unite() {
    for (const auto& [copy, can_convert] : copies_) {
      const bool is_apart = can_convert && stock_.count(copy.second) != 0;
      if (reached_.count(copy.first) != 0 && !is_apart) sets_.unite(copy.first, copy.second);
    }
  }

 private:
  void reach(std::size_t set) {
    if (stock_.count(set) != 0 || !reached_.insert(set).second) return;
    for (auto copy = copies_.lower_bound({set, 0}); copy != copies_.end() && copy->first.first == set; ++copy)
      reach(copy->first.second);
  }

  UnionFind& sets_;
  std::map<std::pair<std::size_t, std::size_t>, bool>
      copies_;  ///< from, to; whether a conversion can be written for all
  std::set<std::size_t> stock_, reached_;
};

/// `Image a, b;` has one type for two variables, unless it can be cut.
void unite_spellings(const Facts& facts, const Numbers& numbers, UnionFind& sets) {
  std::map<std::pair<std::string, unsigned>, std::size_t> owner;
  const std::set<EntityId> alone = separable(facts);
  for (const auto& [id, entity] : facts.entities)
    for (const Change& change : entity.changes) {
      if (alone.count(id) != 0) continue;
      const std::size_t number = numbers.at(id);
      const auto [known, is_new] =
          owner.emplace(std::make_pair(change.where.file, change.where.begin), number);
      if (!is_new) sets.unite(known->second, number);
    }
}

Numbers number(const Facts& facts) {
  Numbers numbers;
  for (const auto& item : facts.entities) numbers.emplace(item.first, numbers.size());
  return numbers;
}

ComponentKind kind_of(EntityRole role) {
  switch (role) {
    case EntityRole::message:
      return ComponentKind::message;
    case EntityRole::publisher:
      return ComponentKind::publisher;
    case EntityRole::filter:
      break;
  }
  return ComponentKind::filter;
}

/// A variable that is declared twice would have to be cut twice.
bool is_written_once(const Entity& entity, const Cut& cut) {
  return std::all_of(entity.changes.begin(), entity.changes.end(), [&](const Change& change) {
    const Place& where = change.where;
    return where.file == cut.words.file && where.begin >= cut.words.begin && where.end <= cut.words.end;
  });
}

}  // namespace

std::set<EntityId> separable(const Facts& facts) {
  std::map<std::pair<std::string, unsigned>, std::set<EntityId>> declarations;
  for (const auto& [id, entity] : facts.entities)
    for (const Change& change : entity.changes)
      declarations[{change.where.file, change.where.begin}].insert(id);
  std::set<EntityId> found;
  for (const auto& [where, names] : declarations) {
    std::set<EntityId> cut;
    for (const EntityId& id : names) {
      const auto at = facts.cuts.find(id);
      if (at != facts.cuts.end() && names.count(at->second.left) != 0 &&
          is_written_once(facts.entities.at(id), at->second))
        cut.insert(id);
    }
    if (cut.size() + 1 == names.size()) found.merge(cut);
  }
  return found;
}

bool is_given_away(const Component& publisher) {
  return std::any_of(publisher.entities.begin(), publisher.entities.end(), [](const Entity* entity) {
    return std::any_of(entity->obstacles.begin(), entity->obstacles.end(),
                       [](const Obstacle& one) { return one.code == codes::TZC1010; });
  });
}

Components::Components(const Facts& facts, bool all_or_nothing) {
  add_entities(facts, all_or_nothing);
  for (const auto& [id, site] : facts.subscribes) {
    Component& component = add(ComponentKind::subscription);
    component.subscription = &site;
    of_site_.emplace(id, component.id);
  }
  for (const auto& [id, site] : facts.publishes) {
    if (site.attaching.changes.empty()) continue;
    Component& component = add(ComponentKind::publish_call);
    component.publish_call = &site;
    of_site_.emplace(id, component.id);
  }
  for (const auto& [id, site] : facts.advertises) {
    if (site.attaching.changes.empty()) continue;
    Component& component = add(ComponentKind::advertise_call);
    component.advertise_call = &site;
    of_site_.emplace(id, component.id);
  }
}

Component& Components::add(ComponentKind kind) {
  Component component;
  component.id = static_cast<ComponentId>(components_.size());
  component.kind = kind;
  components_.push_back(std::move(component));
  return components_.back();
}

void Components::add_entities(const Facts& facts, bool all_or_nothing) {
  const Numbers numbers = number(facts);
  UnionFind sets(numbers.size());
  if (all_or_nothing) unite_flows(facts, numbers, sets);
  unite_spellings(facts, numbers, sets);
  if (all_or_nothing) Copies(facts, numbers, sets).unite();
  std::map<std::size_t, std::size_t> component_of_root;
  for (const auto& [id, entity] : facts.entities) {
    const auto [known, is_new] = component_of_root.emplace(sets.find(numbers.at(id)), components_.size());
    if (is_new) add(kind_of(entity.role));
    Component& component = components_[known->second];
    component.entities.push_back(&entity);
    of_entity_.emplace(id, component.id);
  }
  for (const AllocationSite& site : facts.allocations)
    if (const auto component = of_entity_.find(site.entity); site.start && component != of_entity_.end())
      components_[static_cast<std::size_t>(component->second)].has_lasting_start = true;
}

bool Component::has_lasting_message() const {
  return has_lasting_start || std::any_of(entities.begin(), entities.end(), [](const Entity* entity) {
           return entity->form != Form::elsewhere && entity->lasts();
         });
}

const Component* Components::of(const EntityId& entity) const {
  const auto found = of_entity_.find(entity);
  return found == of_entity_.end() ? nullptr : &(*this)[found->second];
}

const Component* Components::of(const SiteId& site) const {
  const auto found = of_site_.find(site);
  return found == of_site_.end() ? nullptr : &(*this)[found->second];
}

}  // namespace tzc::rewriter
