// SPDX-License-Identifier: BSD-3-Clause
#include "solve/started_messages.h"

#include <algorithm>
#include <vector>

#include "model/codes.h"

namespace tzc::rewriter {

StartedMessages::StartedMessages(const Facts& facts) {
  for (const Flow& flow : facts.flows)
    if (!flow.copies) next_.emplace(flow.from, flow.to);
  for (const AllocationSite& site : facts.allocations) {
    if (!site.start || !site.start->is_member) continue;
    members_.insert(site.start->usr);
    follow(site);
  }
  if (members_.empty()) return;
  for (const auto& [usr, flow] : facts.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events)
        if (event.kind == ContentEvent::Kind::publish)
          names_[event.site].insert(event.part.substr(0, event.part.find_first_of("/[")));
}

/// What is copied is another message.
void StartedMessages::follow(const AllocationSite& start) {
  std::vector<EntityId> open{start.entity};
  while (!open.empty()) {
    const EntityId at = std::move(open.back());
    open.pop_back();
    if (!started_.emplace(at, &start).second) continue;
    const auto [begin, end] = next_.equal_range(at);
    for (auto flow = begin; flow != end; ++flow) open.push_back(flow->second);
  }
}

bool StartedMessages::is_named_by_member(const Publish& fact) const {
  const auto names = names_.find({fact.where.file, fact.where.begin});
  return names != names_.end() &&
         std::all_of(names->second.begin(), names->second.end(), [&](const std::string& name) {
           return members_.count(name) != 0 || is_parameter(name);
         });
}

std::optional<Obstacle> StartedMessages::given_away(const Publish& fact) const {
  for (const EntityId& message : fact.messages) {
    const auto found = started_.find(message);
    if (found == started_.end() || is_named_by_member(fact)) continue;
    const Location& where = found->second->where;
    return Obstacle{
        codes::TZC1019,
        "line " + std::to_string(where.line) +
            " makes it with its object, where no statement can stand, and the object gives it away",
        where};
  }
  return {};
}

}  // namespace tzc::rewriter
