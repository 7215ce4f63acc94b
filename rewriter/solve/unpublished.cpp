// SPDX-License-Identifier: BSD-3-Clause
#include "solve/unpublished.h"

namespace tzc::rewriter {
namespace {

std::string root_of(const MessagePart& part) {
  return part.substr(0, part.find_first_of("/["));
}

/// Whether the elements of one part become those of another, so that both may be published under either's name.
bool exchanges(const ContentEvent& event) {
  using Kind = ContentEvent::Kind;
  return event.kind == Kind::exchange || event.kind == Kind::alias || event.kind == Kind::perhaps;
}

}  // namespace

Unpublished::Unpublished(const Facts& facts) : facts_(facts) {
  for (const Flow& flow : facts.flows) {
    to_.emplace(flow.from, flow.to);
    from_.emplace(flow.to, flow.from);
  }
  for (const auto& item : facts.publishes)
    published_.insert(item.second.messages.begin(), item.second.messages.end());
  for (const auto& [usr, flow] : facts.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events)
        if (exchanges(event)) exchanged_.insert({root_of(event.part), root_of(event.other)});
  for (const AllocationSite& site : facts.allocations)
    if (site.is_apart && stays_apart(site.entity)) messages_.insert(site.entity);
}

bool Unpublished::is_exchanged(const EntityId& parameter) const {
  const std::string& name = parameter.text();  // the function's USR and "#p2"
  const std::size_t index = name.rfind("#p");
  return index == std::string::npos ||
         exchanged_.count(parameter_root(name.substr(0, index),
                                         static_cast<unsigned>(std::stoul(name.substr(index + 2))))) != 0;
}

/// Both ways along the flows, because references and pointers lead back, but not from a parameter to other callers.
std::vector<EntityId> Unpublished::next_to(const EntityId& entity) const {
  std::vector<EntityId> next;
  const auto add = [&](const std::multimap<EntityId, EntityId>& flows) {
    const auto [begin, end] = flows.equal_range(entity);
    for (auto flow = begin; flow != end; ++flow) next.push_back(flow->second);
  };
  add(to_);
  if (facts_.parameters.count(entity) == 0) add(from_);
  return next;
}

bool Unpublished::stays_apart(const EntityId& message) const {
  std::vector<EntityId> open{message};
  std::set<EntityId> known;
  while (!open.empty()) {
    const EntityId one = std::move(open.back());
    open.pop_back();
    if (!known.insert(one).second) continue;
    const bool is_parameter = facts_.parameters.count(one) != 0;
    if (published_.count(one) != 0 || (is_parameter && is_exchanged(one))) return false;
    for (EntityId& next : next_to(one)) open.push_back(std::move(next));
  }
  return true;
}

}  // namespace tzc::rewriter
