// SPDX-License-Identifier: BSD-3-Clause
#include "solve/unallocated_messages.h"

#include <algorithm>
#include <vector>

#include "model/codes.h"

namespace tzc::rewriter {
namespace {

Obstacle why_started(const AllocationSite& site) {
  return {codes::TZC1022,
          "line " + std::to_string(site.where.line) +
              " makes it with its object, which gives it away: it may be another one each time, with "
              "elements outside shared "
              "memory",
          site.where};
}

}  // namespace

UnallocatedMessages::UnallocatedMessages(const Facts& facts) {
  for (const Flow& flow : facts.flows)
    if (!flow.copies) next_.emplace(flow.from, flow.to);
  for (const AllocationSite& site : facts.allocations) {
    if (!site.start || !site.start->is_member) continue;
    members_.insert(site.start->usr);
    follow(site.entity, why_started(site), started_);
  }
  for (const auto& [usr, flow] : facts.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events)
        if (event.kind == ContentEvent::Kind::publish)
          names_[event.site].insert(event.part.substr(0, event.part.find_first_of("/[")));
}

/// What is copied is another message.
void UnallocatedMessages::follow(const EntityId& from, const Obstacle& why, Reached& reached) const {
  std::vector<EntityId> open{from};
  while (!open.empty()) {
    const EntityId at = std::move(open.back());
    open.pop_back();
    if (!reached.emplace(at, why).second) continue;
    const auto [begin, end] = next_.equal_range(at);
    for (auto flow = begin; flow != end; ++flow) open.push_back(flow->second);
  }
}

bool UnallocatedMessages::is_named_by_member(const Publish& fact) const {
  const auto names = names_.find({fact.where.file, fact.where.begin});
  return names != names_.end() &&
         std::all_of(names->second.begin(), names->second.end(), [&](const std::string& name) {
           return members_.count(name) != 0 || is_parameter(name);
         });
}

std::optional<Obstacle> UnallocatedMessages::why_copied(const Publish& fact) const {
  for (const EntityId& message : fact.messages)
    if (const auto found = started_.find(message); found != started_.end() && !is_named_by_member(fact))
      return found->second;
  return {};
}

}  // namespace tzc::rewriter
