// SPDX-License-Identifier: BSD-3-Clause
#include "solve/light_messages.h"

#include <algorithm>
#include <tuple>

#include "model/codes.h"

namespace tzc::rewriter {
namespace {

template <class Site>
void leave(std::map<SiteId, Site>& sites, std::uint64_t small) {
  for (auto& item : sites)
    if (item.second.most_bytes && *item.second.most_bytes < small) item.second.has_data_part = false;
}

/// Parts of a message may be made any number of times.
bool is_of_one_type(const Component& component) {
  return std::all_of(component.entities.begin(), component.entities.end(),
                     [&](const Entity* entity) { return entity->type == component.entities.front()->type; });
}

/// A use in a header is seen by every unit that includes it, one in a template by every instance.
using Places = std::map<std::tuple<std::string, unsigned, unsigned>, std::uint64_t>;

}  // namespace

void leave_light_types(Facts& facts, std::uint64_t small) {
  leave(facts.advertises, small);
  leave(facts.publishes, small);
  leave(facts.subscribes, small);
}

bool publishes_light_message(const Publish& site, const Components& components, const Solution& solution) {
  if (!site.has_data_part && !site.pcl) return true;
  const bool is_foreign = std::any_of(site.obstacles.begin(), site.obstacles.end(),
                                      [](const Obstacle& one) { return one.code == codes::TZC1013; });
  return !is_foreign && !site.messages.empty() &&
         std::all_of(site.messages.begin(), site.messages.end(), [&](const EntityId& id) {
           const Component* message = components.of(id);
           const Decision* decision = message ? solution.of(message->id) : nullptr;
           return decision && decision->outcome == Outcome::not_needed;
         });
}

LightMessages::LightMessages(const Facts& facts, const Components& components) {
  for (const DataUse& use : facts.data_uses)
    if (const Component* message = components.of(use.entity)) uses_[message->id].push_back(&use);
  // Another message may give it any number of elements.
  for (const Flow& flow : facts.flows) {
    const Component* from = components.of(flow.from);
    const Component* to = components.of(flow.to);
    if (!flow.copies || !from || !to || from->id == to->id) continue;
    uses_[to->id];
    unbounded_.insert(to->id);
  }
  for (const DataWrite& write :
       facts.data_writes)  // who casts the const of an array away may change its size
    if (const Component* message = components.of(write.message); message && write.to_array)
      unbounded_.insert(message->id);
}

std::optional<std::uint64_t> LightMessages::most_bytes(const Component& component) const {
  const auto uses = uses_.find(component.id);
  if (uses == uses_.end()) return 0;
  if (unbounded_.count(component.id) != 0 || !is_of_one_type(component)) return {};
  Places places;
  for (const DataUse* use : uses->second) {
    // A message that is copied to and fro may grow each time.
    if (!use->most_bytes || (use->appends && component.entities.size() > 1)) return {};
    const Location& where = use->where;
    std::uint64_t& bytes = places[std::make_tuple(where.file, where.line, where.column)];
    bytes = std::max(bytes, *use->most_bytes);
  }
  std::uint64_t sum = 0;
  for (const auto& item : places) sum += item.second;
  return sum;
}

}  // namespace tzc::rewriter
