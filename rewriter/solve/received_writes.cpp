// SPDX-License-Identifier: BSD-3-Clause
#include "solve/received_writes.h"

#include <algorithm>

#include "model/codes.h"

namespace tzc::rewriter {

ReceivedWrites::ReceivedWrites(const Facts& facts) : facts_(facts) {
  for (const Flow& flow : facts.flows)
    if (facts.objects.count(flow.to) == 0) next_.emplace(flow.from, flow.to);
}

bool ReceivedWrites::derives(const std::string& record, const std::string& base) const {
  if (record == base) return true;
  const auto bases = facts_.bases.find(record);
  return bases != facts_.bases.end() &&
         std::any_of(bases->second.begin(), bases->second.end(),
                     [&](const std::string& next) { return derives(next, base); });
}

/// Those of the class that subscribes, its bases and what derives from it; else any: the filter was handed on.
std::vector<const FilterCallbackUse*> ReceivedWrites::registered(const Subscribe& site) const {
  if (site.filter.empty()) return {};
  std::vector<const FilterCallbackUse*> own, all;
  for (const auto& [callback, use] : facts_.filter_callbacks) {
    if (callback.type != site.type) continue;
    all.push_back(&use);
    if (derives(callback.scope, site.scope) || derives(site.scope, callback.scope)) own.push_back(&use);
  }
  return own.empty() ? all : own;
}

bool ReceivedWrites::takes_own(const Subscribe& site) const {
  const std::vector<const FilterCallbackUse*> uses = registered(site);
  return site.writes ||
         std::any_of(uses.begin(), uses.end(), [](const FilterCallbackUse* use) { return use->writes; });
}

std::set<EntityId> ReceivedWrites::received(const Subscribe& site) const {
  std::vector<EntityId> open = site.callbacks;
  for (const FilterCallbackUse* use : registered(site))
    open.insert(open.end(), use->parameters.begin(), use->parameters.end());
  std::set<EntityId> known;
  while (!open.empty()) {
    const EntityId one = open.back();
    open.pop_back();
    if (!known.insert(one).second) continue;
    const auto [begin, end] = next_.equal_range(one);
    for (auto next = begin; next != end; ++next) open.push_back(next->second);
  }
  return known;
}

std::optional<Obstacle> ReceivedWrites::write(const Subscribe& site, bool to_array) const {
  const std::set<EntityId> messages = received(site);
  for (const DataWrite& write : facts_.data_writes)
    if (write.to_array == to_array && messages.count(write.message) != 0) return write.obstacle;
  return {};
}

std::optional<Obstacle> ReceivedWrites::to_message(const Subscribe& site) const {
  for (const EntityId& key : received(site)) {
    const auto entity = facts_.entities.find(key);
    if (entity == facts_.entities.end()) continue;
    for (const Obstacle& obstacle : entity->second.obstacles)
      if (obstacle.code == codes::TZC2002) return obstacle;
  }
  return write(site, true);
}

std::optional<Obstacle> ReceivedWrites::to_elements(const Subscribe& site) const {
  return write(site, false);
}

}  // namespace tzc::rewriter
