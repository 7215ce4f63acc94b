// SPDX-License-Identifier: BSD-3-Clause
#include "solve/received_writes.h"

#include "model/codes.h"

namespace tzc::rewriter {

ReceivedWrites::ReceivedWrites(const Facts& facts) : facts_(facts) {
  for (const Flow& flow : facts.flows)
    if (facts.objects.count(flow.to) == 0) next_.emplace(flow.from, flow.to);
}

std::set<EntityId> ReceivedWrites::received(const Subscribe& site) const {
  std::vector<EntityId> open = site.callbacks;
  const auto registered = facts_.filter_callbacks.find({site.scope, site.type});
  if (!site.filter.empty() && registered != facts_.filter_callbacks.end())
    open.insert(open.end(), registered->second.parameters.begin(), registered->second.parameters.end());
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
