// SPDX-License-Identifier: BSD-3-Clause
#include "solve/components.h"

#include <deque>
#include <numeric>

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

using Numbers = std::map<Key, std::size_t>;

bool same_kind(const Facts& facts, const Key& a, const Key& b) {
  return facts.entities.at(a).carrier == facts.entities.at(b).carrier;
}

void unite_flows(const Facts& facts, const Numbers& numbers, UnionFind& sets) {
  for (const Flow& flow : facts.flows) {
    const auto from = numbers.find(flow.from), to = numbers.find(flow.to);
    if (from != numbers.end() && to != numbers.end() && same_kind(facts, flow.from, flow.to))
      sets.unite(from->second, to->second);
  }
}

/// `Image a, b;` has one type for two variables.
void unite_spellings(const Facts& facts, const Numbers& numbers, UnionFind& sets) {
  std::map<std::pair<std::string, unsigned>, std::size_t> owner;
  for (const auto& [key, entity] : facts.entities)
    for (const Change& change : entity.changes) {
      const std::size_t number = numbers.at(key);
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

}  // namespace

Components::Components(const Facts& facts, bool all_or_nothing) {
  const Numbers numbers = number(facts);
  UnionFind sets(numbers.size());
  if (all_or_nothing) unite_flows(facts, numbers, sets);
  unite_spellings(facts, numbers, sets);
  std::map<std::size_t, std::size_t> component_of_root;
  for (const auto& [key, entity] : facts.entities) {
    const std::size_t root = sets.find(numbers.at(key));
    const auto [known, is_new] = component_of_root.emplace(root, components_.size());
    if (is_new) {
      components_.push_back({});
      components_.back().id = static_cast<int>(known->second);
      components_.back().carrier = entity.carrier;
      components_.back().name = key;
    }
    components_[known->second].entities.push_back(&entity);
    index_[key] = known->second;
  }
}

const Component* Components::of(const Key& key) const {
  const auto found = index_.find(key);
  return found == index_.end() ? nullptr : &components_[found->second];
}

Neighbours flow_neighbours(const Facts& facts) {
  Neighbours neighbours;
  for (const Flow& flow : facts.flows) {
    neighbours[flow.from].push_back(flow.to);
    neighbours[flow.to].push_back(flow.from);
  }
  return neighbours;
}

std::set<Key> reachable(const Neighbours& neighbours, const Key& from) {
  std::set<Key> seen{from};
  std::deque<Key> queue{from};
  while (!queue.empty()) {
    const auto found = neighbours.find(queue.front());
    queue.pop_front();
    if (found == neighbours.end()) continue;
    for (const Key& next : found->second)
      if (seen.insert(next).second) queue.push_back(next);
  }
  return seen;
}

std::vector<FlowStep> chain_between(const Facts& facts, const Key& from, const Key& to) {
  std::map<Key, std::vector<std::pair<Key, const Flow*>>> neighbours;
  for (const Flow& flow : facts.flows) {
    neighbours[flow.from].push_back({flow.to, &flow});
    neighbours[flow.to].push_back({flow.from, &flow});
  }
  std::map<Key, std::pair<Key, const Flow*>> came_from{{from, {"", nullptr}}};
  std::deque<Key> queue{from};
  while (!queue.empty() && came_from.count(to) == 0) {
    const Key here = queue.front();
    queue.pop_front();
    for (const auto& [next, flow] : neighbours[here])
      if (came_from.emplace(next, std::make_pair(here, flow)).second) queue.push_back(next);
  }
  std::vector<FlowStep> steps;
  if (came_from.count(to) == 0) return steps;
  for (Key here = to; here != from; here = came_from.at(here).first) {
    const Flow& flow = *came_from.at(here).second;
    steps.insert(steps.begin(), {flow.where, flow.what});
  }
  return steps;
}

}  // namespace tzc::rewriter
