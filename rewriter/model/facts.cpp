// SPDX-License-Identifier: BSD-3-Clause
#include "model/facts.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "model/append.h"
#include "model/codes.h"
#include "model/erase_if.h"

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

/// Programs of one package may give one name to different things.
bool same(const Entity& a, const Entity& b) {
  return a.role == b.role && a.storage == b.storage && a.ported_as.name == b.ported_as.name;
}

Obstacle named_twice(const Entity& entity) {
  return {codes::TZC1001, "'" + entity.name + "' is something else in another program of the package",
          entity.where};
}

template <class T>
void unite(std::vector<T>& into, std::vector<T>& from) {
  for (T& item : from) {
    const bool known = std::any_of(into.begin(), into.end(), [&](const T& t) { return same(t, item); });
    if (!known) into.push_back(std::move(item));
  }
}

void unite(std::map<EntityId, Entity>& into, std::map<EntityId, Entity>& from) {
  for (auto& [id, entity] : from) {
    auto [known, is_new] = into.emplace(id, entity);
    if (is_new) continue;
    if (!same(known->second, entity)) known->second.obstacles.push_back(named_twice(entity));
    unite(known->second.changes, entity.changes);
    unite(known->second.obstacles, entity.obstacles);
  }
}

/// Instances of a template, and units, may give one subscription different callbacks.
void unite(std::map<SiteId, Subscribe>& into, std::map<SiteId, Subscribe>& from) {
  for (auto& [id, site] : from)
    if (auto [known, is_new] = into.emplace(id, site); !is_new) known->second.add_callbacks(site);
}

void unite(std::map<EntityId, Factory>& into, std::map<EntityId, Factory>& from) {
  for (auto& [id, factory] : from)
    if (auto [known, is_new] = into.emplace(id, factory); !is_new)
      unite(known->second.declarations, factory.declarations);
}

template <class Key>
void unite(std::map<Key, std::set<std::string>>& into, std::map<Key, std::set<std::string>>& from) {
  for (auto& [key, values] : from) into[key].insert(values.begin(), values.end());
}

}  // namespace

std::set<std::string> ClassFacts::with_bases(const std::string& record) const {
  std::set<std::string> found;
  std::vector<std::string> open{record};
  while (!open.empty()) {
    const std::string next = std::move(open.back());
    open.pop_back();
    if (!found.insert(next).second) continue;
    if (const auto known = bases.find(next); known != bases.end())
      open.insert(open.end(), known->second.begin(), known->second.end());
  }
  return found;
}

bool UnitFacts::is_of_one_program(const std::string& file) const {
  const auto units = units_of_file.find(file);
  return programs.count(file) != 0 && parts.count(file) == 0 && units != units_of_file.end() &&
         units->second == std::set<std::string>{file};
}

bool UnitFacts::share_a_process(const std::string& file, const std::string& other) const {
  return file == other || !is_of_one_program(file) || !is_of_one_program(other);
}

void Facts::add_parameter(const EntityId& id, bool is_own) {
  const auto [known, is_new] = own_parameters.emplace(id, is_own);
  if (!is_new) known->second = known->second && is_own;
}

void Facts::refuse_unseen_functions() {
  for (const auto& [id, function] : parameters) {
    const auto entity = entities.find(id);
    if (entity == entities.end() || bodies.count(function) != 0) continue;
    Entity& parameter = entity->second;
    parameter.obstacles.push_back(
        {codes::TZC1001, "'" + parameter.name + "' is a parameter of a function whose body was not seen",
         parameter.where});
  }
}

void Facts::refuse_unseen_friends() {
  for (const auto& [id, usrs] : friends) {
    const auto entity = entities.find(id);
    const bool seen = std::all_of(usrs.begin(), usrs.end(), [&](const std::string& usr) {
      return records.count(usr) != 0 || bodies.count(usr) != 0;
    });
    if (entity != entities.end() && !seen)
      entity->second.obstacles.push_back(
          {codes::TZC1005, "a friend of its class, which other packages may include, is not defined here",
           entity->second.where, true});
  }
}

void Facts::leave_out_unshown_code() {
  const auto is_out = [&](const PublishEvent& event) { return !event.if_shown.is_met_by(hidden_code); };
  erase_if(holds, [&](const DataHold& hold) { return is_out(hold.event); });
  erase_if(loud_tails, [&](const LoudTail& tail) { return !tail.if_shown.is_met_by(hidden_code); });
  for (auto& [usr, events] : effects) erase_if(events, is_out);
  for (auto at = contents.begin(); at != contents.end();) {
    at->second.leave_out_all_but(hidden_code);
    at = at->second.is_empty() ? contents.erase(at) : std::next(at);
  }
}

void Facts::add_overrides() {
  const std::map<std::string, std::vector<PublishEvent>> own = effects;
  for (const auto& [function, others] : overrides) {
    std::vector<PublishEvent>& events = effects[function];
    for (const std::string& other : others) {
      const auto seen = own.find(other);
      if (seen == own.end())
        events.push_back({PublishEvent::Kind::unknown, {}, {}});
      else
        events.insert(events.end(), seen->second.begin(), seen->second.end());
      if (seen == own.end() || locking.count(other)) locking.insert(function);
    }
  }
}

void Subscribe::add_callbacks(const Subscribe& other) {
  writes |= other.writes;
  is_unknown |= other.is_unknown;
  converts |= other.converts;
  for (const EntityId& callback : other.callbacks)
    if (std::count(callbacks.begin(), callbacks.end(), callback) == 0) callbacks.push_back(callback);
}

void Facts::add_content(const std::string& usr, ContentFlow flow) {
  const auto [known, is_new] = contents.emplace(usr, flow);
  if (!is_new) known->second.add_alternative(std::move(flow));
}

static void merge_casts(Facts& facts, Facts& other) {
  append(facts.const_casts, other.const_casts);
  append(facts.foreign_casts, other.foreign_casts);
  append(facts.array_casts, other.array_casts);
  unite(facts.given_arrays, other.given_arrays);
  append(facts.untyped_arrays, other.untyped_arrays);
}

void Facts::merge(Facts&& other) {
  unite(entities, other.entities);
  append(flows, other.flows);
  append(uses, other.uses);
  cuts.merge(other.cuts);
  objects.merge(other.objects);
  parameters.merge(other.parameters);
  bodies.merge(other.bodies);
  records.merge(other.records);
  unite(friends, other.friends);
  append(allocations, other.allocations);
  unite(factories, other.factories);
  append(data_uses, other.data_uses);
  merge_casts(*this, other);
  append(escapes, other.escapes);
  append(holds, other.holds);
  append(loud_tails, other.loud_tails);
  append(data_writes, other.data_writes);
  append(trusted_calls, other.trusted_calls);
  shadows_tzc |= other.shadows_tzc;
  for (auto& [usr, events] : other.effects) append(effects[usr], events);
  lasting.merge(other.lasting);
  early.merge(other.early);
  for (auto& [usr, flow] : other.contents) add_content(usr, std::move(flow));
  append(given.messages, other.given.messages);
  append(given.refills, other.given.refills);
  given.emptied.merge(other.given.emptied);
  unite(given.handed_on, other.given.handed_on);
  unite(given.published_from, other.given.published_from);
  addressed.merge(other.addressed);
  hidden_code.merge(other.hidden_code);
  changing.merge(other.changing);
  locking.merge(other.locking);
  synchronizing.merge(other.synchronizing);
  handing_over.merge(other.handing_over);
  for (auto& [code, others] : other.starts) {
    CodeStarts& mine = starts[code];
    mine.by_one.merge(others.by_one);
    mine.by_any |= others.by_any;
    mine.by_thread |= others.by_thread;
  }
  std::move(other.element_uses.begin(), other.element_uses.end(), std::back_inserter(element_uses));
  advertises.merge(other.advertises);
  for (auto& [name, publishers] : other.library_publishers) library_publishers[name].merge(publishers);
  publishes.merge(other.publishes);
  unite(subscribes, other.subscribes);
  unite(bases, other.bases);
  unite(overrides, other.overrides);
  unite(units_of_file, other.units_of_file);
  programs.merge(other.programs);
  parts.merge(other.parts);
  for (const auto& [id, is_own] : other.own_parameters) add_parameter(id, is_own);
  for (auto& [callback, use] : other.filter_callbacks) {
    FilterCallbackUse& known = filter_callbacks[callback];
    known.writes |= use.writes;
    known.is_unknown |= use.is_unknown;
    known.parameters.merge(use.parameters);
  }
}

}  // namespace tzc::rewriter
