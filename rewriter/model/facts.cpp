// SPDX-License-Identifier: BSD-3-Clause
#include "model/facts.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace tzc::rewriter {
namespace {

bool same(const Place& a, const Place& b) {
  return std::tie(a.begin, a.end, a.file) == std::tie(b.begin, b.end, b.file);
}

bool same(const Change& a, const Change& b) {
  return same(a.where, b.where) && a.text == b.text;
}

bool same(const Obstacle& a, const Obstacle& b) {
  return a.code == b.code && a.reason == b.reason && a.where.line == b.where.line &&
         a.where.file == b.where.file;
}

template <class T>
void unite(std::vector<T>& into, std::vector<T>& from) {
  for (T& item : from) {
    const bool known = std::any_of(into.begin(), into.end(), [&](const T& t) { return same(t, item); });
    if (!known) into.push_back(std::move(item));
  }
}

template <class T>
void append(std::vector<T>& into, std::vector<T>& from) {
  std::move(from.begin(), from.end(), std::back_inserter(into));
}

void unite(std::map<EntityId, Entity>& into, std::map<EntityId, Entity>& from) {
  for (auto& [id, entity] : from) {
    auto [known, is_new] = into.emplace(id, entity);
    if (is_new) continue;
    unite(known->second.changes, entity.changes);
    unite(known->second.obstacles, entity.obstacles);
  }
}

void unite(std::map<EntityId, Factory>& into, std::map<EntityId, Factory>& from) {
  for (auto& [id, factory] : from)
    if (auto [known, is_new] = into.emplace(id, factory); !is_new)
      unite(known->second.declarations, factory.declarations);
}

void unite(std::map<std::string, std::set<std::string>>& into,
           std::map<std::string, std::set<std::string>>& from) {
  for (auto& [key, values] : from) into[key].insert(values.begin(), values.end());
}

}  // namespace

void Facts::merge(Facts&& other) {
  unite(entities, other.entities);
  append(flows, other.flows);
  append(uses, other.uses);
  cuts.merge(other.cuts);
  objects.merge(other.objects);
  append(allocations, other.allocations);
  unite(factories, other.factories);
  append(data_uses, other.data_uses);
  append(escapes, other.escapes);
  append(holds, other.holds);
  append(loud_tails, other.loud_tails);
  append(data_writes, other.data_writes);
  append(trusted_calls, other.trusted_calls);
  shadows_tzc |= other.shadows_tzc;
  for (auto& [usr, events] : other.effects) append(effects[usr], events);
  lasting.merge(other.lasting);
  early.merge(other.early);
  contents.merge(other.contents);
  addressed.merge(other.addressed);
  changing.merge(other.changing);
  locking.merge(other.locking);
  advertises.merge(other.advertises);
  publishes.merge(other.publishes);
  subscribes.merge(other.subscribes);
  unite(bases, other.bases);
  unite(units_of_file, other.units_of_file);
  for (auto& [callback, use] : other.filter_callbacks) {
    FilterCallbackUse& known = filter_callbacks[callback];
    known.writes |= use.writes;
    known.parameters.merge(use.parameters);
  }
}

}  // namespace tzc::rewriter
