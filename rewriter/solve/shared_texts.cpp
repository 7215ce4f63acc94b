// SPDX-License-Identifier: BSD-3-Clause
#include "solve/shared_texts.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
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

/// Why the port of one contradicts that of another; none: it does not.
std::optional<Decision> contradicted(const Together& group, const Components& components,
                                     const std::map<ComponentId, Decision>& decisions) {
  std::map<std::tuple<std::string, unsigned, unsigned>, std::string> texts;
  for (const ComponentId id : group) {
    if (decisions.at(id).outcome != Outcome::ported) continue;
    const Subscribe& site = *components[id].subscription;
    for (const Change& change : site.changes) {
      const Place& where = change.where;
      const auto [known, is_new] =
          texts.emplace(std::make_tuple(where.file, where.begin, where.end), change.text);
      if (!is_new && known->second != change.text)
        return refused({codes::TZC1007,
                        "the instances of a template, or the ways in which the file is compiled, would need "
                        "another call each",
                        location_of(site.where)});
    }
  }
  return {};
}

/// Why none of them can be ported; none: each can, or none was to be.
std::optional<Decision> why_none(const Together& group, const Components& components,
                                 const std::map<ComponentId, Decision>& decisions) {
  const auto refused = std::find_if(group.begin(), group.end(), [&](ComponentId id) {
    return decisions.at(id).outcome == Outcome::refused;
  });
  if (refused != group.end()) return decisions.at(*refused);
  return contradicted(group, components, decisions);
}

/// Whether some were refused because of others.
bool refuse_all_or_none(const Together& group, const Components& components,
                        std::map<ComponentId, Decision>& decisions) {
  const std::optional<Decision> why = why_none(group, components, decisions);
  bool is_changed = false;
  for (const ComponentId id : group)
    if (why && decisions.at(id).outcome == Outcome::ported) {
      decisions.at(id) = *why;
      is_changed = true;
    }
  return is_changed;
}

}  // namespace

void refuse_together(const Components& components, Solution& solution) {
  const std::vector<Together> groups = groups_of(components);
  for (bool is_changed = true; is_changed;) {
    is_changed = false;
    for (const Together& group : groups)
      is_changed |= refuse_all_or_none(group, components, solution.decisions);
  }
}

}  // namespace tzc::rewriter
