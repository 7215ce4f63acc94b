// SPDX-License-Identifier: BSD-3-Clause
#include "solve/unpublished.h"

namespace tzc::rewriter {
namespace {

/// The elements of one part become those of another, or a pointer leads to them: both may be published under either's name.
bool exchanges(const ContentEvent& event) {
  using Kind = ContentEvent::Kind;
  return event.kind == Kind::exchange || event.kind == Kind::alias || event.kind == Kind::perhaps;
}

std::string root_of(const MessagePart& part) {
  return part.substr(0, part.find_first_of("/["));
}

/// What stands behind the last `mark` in the id.
std::string behind(const EntityId& id, const std::string& mark) {
  const std::size_t at = id.text().rfind(mark);
  return at == std::string::npos ? "" : id.text().substr(at + mark.size());
}

/// Of a parameter: "USR#p2".
std::string root_of_parameter(const EntityId& id, const std::string& function) {
  const std::string index = behind(id, "#p");
  return index.empty() ? "" : parameter_root(function, static_cast<unsigned>(std::stoul(index)));
}

/// Of a local variable: "FILE:OFFSET".
std::string root_of_local(const Entity& variable, const AllocationSite& site) {
  const std::string& result = site.function.text();  // the function's USR and "#r"
  return root_in(result.substr(0, result.rfind('#')), "local " + behind(variable.id, ":") + variable.name);
}

}  // namespace

Unpublished::Unpublished(const Facts& facts) : facts_(facts) {
  for (const Flow& flow : facts.flows) {
    to_.emplace(flow.from, flow.to);
    from_.emplace(flow.to, flow.from);
  }
  for (const auto& item : facts.publishes)
    published_.insert(item.second.messages.begin(), item.second.messages.end());
  read_contents(facts);
  for (const AllocationSite& site : facts.allocations)
    if (stays_apart(site)) messages_.insert(site.entity);
}

void Unpublished::read_contents(const Facts& facts) {
  for (const auto& [usr, flow] : facts.contents)
    for (const ContentBlock& block : flow.blocks)
      for (const ContentEvent& event : block.events) {
        if (event.kind == ContentEvent::Kind::any) unfollowed_.insert(event.part);
        if (!exchanges(event)) continue;
        exchanged_.insert(root_in(usr, root_of(event.part)));
        exchanged_.insert(root_in(usr, root_of(event.other)));
      }
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

bool Unpublished::stays_apart(const AllocationSite& site) const {
  const Entity& variable = facts_.entities.at(site.entity);
  if (variable.storage != Storage::local || variable.form != Form::itself ||
      unfollowed_.count(any_message(variable.type)) != 0 ||
      exchanged_.count(root_of_local(variable, site)) != 0)
    return false;
  std::vector<EntityId> open{site.entity};
  std::set<EntityId> known;
  while (!open.empty()) {
    const EntityId one = std::move(open.back());
    open.pop_back();
    if (!known.insert(one).second) continue;
    const auto parameter = facts_.parameters.find(one);
    const bool is_exchanged = parameter != facts_.parameters.end() &&
                              exchanged_.count(root_of_parameter(one, parameter->second)) != 0;
    if (published_.count(one) != 0 || is_exchanged) return false;
    for (EntityId& next : next_to(one)) open.push_back(std::move(next));
  }
  return true;
}

}  // namespace tzc::rewriter
