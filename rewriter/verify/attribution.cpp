// SPDX-License-Identifier: BSD-3-Clause
#include "verify/attribution.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include "edits/apply.h"
#include "edits/source_text.h"

namespace tzc::rewriter {
namespace {

unsigned line_at(const std::string& content, std::size_t offset) {
  return 1 + static_cast<unsigned>(
                 std::count(content.begin(), content.begin() + static_cast<long>(offset), '\n'));
}

void add_once(std::vector<ComponentId>& list, ComponentId item) {
  if (std::find(list.begin(), list.end(), item) == list.end()) list.push_back(item);
}

std::vector<Location> places_of(const Diagnostic& error) {
  std::vector<Location> places{error.where};
  places.insert(places.end(), error.notes.begin(), error.notes.end());
  return places;
}

}  // namespace

Attribution::Attribution(const Facts& facts, const Components& components, EditedSources sources)
    : facts_(facts), components_(components), contents_(sources.contents), read_(std::move(sources.read)) {
  for (const auto& [file, of_file] : by_file(sources.edits)) {
    const std::string original = read_(file).value_or("");
    if (const auto edited = contents_.find(file); edited != contents_.end())
      lines_.emplace(file, EditedLines(original, of_file, edited->second));
    for (const Edit& edit : of_file) {
      const unsigned line = line_at(original, edit.offset);
      rules_[file][line].insert(edit.rule);
      if (!edit.component) continue;
      edited_.insert(*edit.component);
      edited_lines_[file][*edit.component].insert(line);
    }
  }
}

LineRange Attribution::original(const std::string& file, unsigned line) const {
  const auto found = lines_.find(file);
  return found == lines_.end() ? LineRange{line, line} : found->second.original(line);
}

bool Attribution::has_edit(const std::string& file, unsigned line, const std::set<std::string>& rules) const {
  const auto of_file = rules_.find(file);
  if (of_file == rules_.end()) return false;
  const auto here = of_file->second.find(line);
  return here != of_file->second.end() && std::any_of(rules.begin(), rules.end(), [&](const auto& rule) {
           return here->second.count(rule) != 0;
         });
}

/// Whether a use, a flow or a publish call of the component is on these lines of the original.
bool Attribution::owns_line(ComponentId component, const std::string& file, const LineRange& lines) const {
  const auto here = [&](const Location& where) { return lines.has(where.line) && where.file == file; };
  const auto mine = [&](const EntityId& key) {
    const Component* of = components_.of(key);
    return of && of->id == component;
  };
  for (const DataUse& use : facts_.data_uses)
    if (here(use.where) && mine(use.entity)) return true;
  for (const Flow& flow : facts_.flows)
    if (here(flow.where) && (mine(flow.from) || mine(flow.to))) return true;
  for (const auto& item : facts_.publishes) {
    if (!here(location_of(item.second.where))) continue;
    if (mine(item.second.publisher)) return true;
    for (const EntityId& key : item.second.messages)
      if (mine(key)) return true;
  }
  return false;
}

std::vector<ComponentId> Attribution::suspects_of(const Diagnostic& error) const {
  std::vector<ComponentId> suspects;
  for (const Location& place : places_of(error)) {
    const LineRange lines = original(place.file, place.line);
    for (const ComponentId component : edited_)
      if (owns_line(component, place.file, lines)) add_once(suspects, component);
    const auto of_file = edited_lines_.find(place.file);
    if (of_file == edited_lines_.end()) continue;
    for (const auto& [component, edited] : of_file->second)
      if (const auto line = edited.lower_bound(lines.first); line != edited.end() && *line <= lines.last)
        add_once(suspects, component);
  }
  return suspects;
}

std::string Attribution::edited_line(const Location& where) const {
  const auto edited = contents_.find(where.file);
  std::istringstream stream(edited == contents_.end() ? read_(where.file).value_or("") : edited->second);
  std::string line;
  for (unsigned number = 0; number < where.line && std::getline(stream, line); ++number) continue;
  return line;
}

std::set<ComponentId> Attribution::named_at(const Diagnostic& error) const {
  std::set<ComponentId> named;
  for (const Location& place : places_of(error)) {
    const std::set<std::string> words = identifiers_in(edited_line(place));
    for (const ComponentId id : edited_)
      for (const Entity* entity : components_[id].entities)
        if (words.count(entity->name)) named.insert(id);
  }
  return named;
}

std::set<ComponentId> Attribution::edited_in(const std::set<std::string>& files) const {
  std::set<ComponentId> found;
  for (const auto& [file, components] : edited_lines_)
    if (files.count(file))
      for (const auto& item : components) found.insert(item.first);
  return found;
}

}  // namespace tzc::rewriter
