// SPDX-License-Identifier: BSD-3-Clause
#include "solve/shared_texts.h"

#include <algorithm>
#include <map>
#include <tuple>
#include <vector>

namespace tzc::rewriter {
namespace {

using Together = std::vector<ComponentId>;

std::vector<Together> groups_of(const Components& components) {
  std::map<std::tuple<std::string, unsigned, std::vector<unsigned>>, Together> of_text;
  std::map<ComponentId, Together> of_filter;
  for (const Component& component : components.all()) {
    if (component.kind != ComponentKind::subscription || !component.subscription->has_data_part) continue;
    const SiteId id = component.subscription->id();
    of_text[{id.file, id.begin, id.in_macros}].push_back(component.id);
    if (const Component* filter = components.of(component.subscription->filter))
      of_filter[filter->id].push_back(component.id);
  }
  std::vector<Together> groups;
  for (auto& item : of_text) groups.push_back(std::move(item.second));
  for (auto& item : of_filter) groups.push_back(std::move(item.second));
  return groups;
}

/// Whether some were refused because of others.
bool refuse_all_or_none(const Together& group, std::map<ComponentId, Decision>& decisions) {
  const auto find = [&](Outcome outcome) {
    return std::find_if(group.begin(), group.end(),
                        [&](ComponentId id) { return decisions.at(id).outcome == outcome; });
  };
  const auto refused = find(Outcome::refused);
  if (refused == group.end() || find(Outcome::ported) == group.end()) return false;
  const Decision why = decisions.at(*refused);
  for (const ComponentId id : group)
    if (decisions.at(id).outcome == Outcome::ported) decisions.at(id) = why;
  return true;
}

}  // namespace

void refuse_together(const Components& components, Solution& solution) {
  const std::vector<Together> groups = groups_of(components);
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const Together& group : groups) is_changed |= refuse_all_or_none(group, solution.decisions);
  }
}

}  // namespace tzc::rewriter
