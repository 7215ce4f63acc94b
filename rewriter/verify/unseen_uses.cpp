// SPDX-License-Identifier: BSD-3-Clause
#include "verify/unseen_uses.h"

#include <algorithm>
#include <regex>
#include <utility>

#include "edits/dual.h"
#include "edits/source_text.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

/// Code that no configuration compiles.
bool is_dead(const std::string& branch) {
  static const std::regex zero("^\\s*#\\s*(el)?if\\s+(0|false)\\b");
  return std::regex_search(branch, zero, std::regex_constants::match_continuous);
}

}  // namespace

std::vector<Place> compiled_by_none(const std::vector<Place>& skipped,
                                    const std::set<BranchDirective>& compiled) {
  // Where a unit stops skipping earlier than another one, at an #elif or #else, it compiles the rest.
  std::map<std::pair<std::string, unsigned>, Place> shortest;
  for (const Place& place : skipped) {
    if (compiled.count({place.file, place.line})) continue;
    Place& known = shortest.emplace(std::pair(place.file, place.begin), place).first->second;
    if (place.end < known.end) known = place;
  }
  std::vector<Place> places;
  for (auto& item : shortest) places.push_back(std::move(item.second));
  return places;
}

std::vector<Place> dropped_by_all(const std::vector<Place>& dropped, const std::set<ArgumentPlace>& kept) {
  std::map<ArgumentPlace, Place> places;
  for (const Place& place : dropped)
    if (const ArgumentPlace at{place.file, place.begin}; kept.count(at) == 0) places.emplace(at, place);
  std::vector<Place> all;
  for (auto& item : places) all.push_back(std::move(item.second));
  return all;
}

UnseenUses::UnseenUses(const UnseenCode& unseen, const Facts& facts, const Components& components,
                       const ReadFile& read)
    : facts_(facts), components_(components) {
  for (const Place& place : unseen.branches) add_branch(place, read);
  for (const Place& place : unseen.arguments) add_argument(place, read);
  for (const UnseenFile& file : unseen.files) add_file(file, read);
  if (parts_.empty()) return;
  for (const Component& component : components.all())
    for (const Entity* entity : component.entities)
      if (!texts_.count(entity->where.file))
        texts_[entity->where.file] = without_comments(read(entity->where.file).value_or(""));
}

void UnseenUses::add(Kind kind, const Place& where, std::string code, const UnseenFile* file) {
  std::set<std::string> words = identifiers_in(code);
  parts_.push_back({kind, where, std::move(code), std::move(words), file});
}

void UnseenUses::add_argument(const Place& place, const ReadFile& read) {
  const std::string text = read(place.file).value_or("");
  if (place.end <= text.size())
    add(Kind::argument, place, without_comments(text.substr(place.begin, place.end - place.begin)));
}

void UnseenUses::add_branch(const Place& place, const ReadFile& read) {
  const std::string text = read(place.file).value_or("");
  if (place.end > text.size() || place.begin >= place.end || in_dual_branch(text, place.line + 1)) return;
  const std::string branch = text.substr(place.begin, place.end - place.begin);
  if (is_dead(branch)) return;
  add(Kind::branch, place, without_comments(branch));
  const auto [known, is_new] = texts_.try_emplace(place.file);
  if (!is_new) return;
  known->second = without_comments(text);
  conditional_.emplace(place.file, known->second);
}

void UnseenUses::add_file(const UnseenFile& file, const ReadFile& read) {
  Place whole;
  whole.file = file.file;
  whole.line = whole.column = 1;
  add(Kind::file, whole, without_comments(read(file.file).value_or("")), &file);
}

bool UnseenUses::compiled_together(const std::string& file, const std::string& other) const {
  const auto one = facts_.units_of_file.find(file), two = facts_.units_of_file.find(other);
  if (one == facts_.units_of_file.end() || two == facts_.units_of_file.end()) return false;
  return std::any_of(one->second.begin(), one->second.end(),
                     [&](const std::string& unit) { return two->second.count(unit) != 0; });
}

/// Whether the compiler would see the entity's declaration there. A private member is named in functions of its class only, and
/// in friends, which name the class as well; friends in other packages have refused it before.
bool UnseenUses::may_name(const Part& part, const Entity& entity) const {
  if (!part.file) return compiled_together(part.where.file, entity.where.file);
  if (entity.member_of.is_private && part.file->place == UnseenFile::Place::other_package) return false;
  const std::string record = entity.member_of.record.substr(entity.member_of.record.find_last_of('@') + 1);
  if (entity.member_of.is_private && !record.empty() && part.words.count(record) == 0) return false;
  return part.file->headers.count(entity.where.file) != 0 ||
         std::any_of(entity.changes.begin(), entity.changes.end(),
                     [&](const Change& change) { return part.file->headers.count(change.where.file) != 0; });
}

/// Whether the part compiles with a ros::Publisher as with a tzc::Publisher. Those of image_transport are not the same: their
/// publish() takes whatever converts to an image. A file may belong to a target that is not linked with TZC.
bool UnseenUses::fits_either_class(const Part& part, const Entity& entity) {
  static const std::set<std::string> members{"publish", "getNumSubscribers", "getTopic", "isLatched",
                                             "shutdown"};
  return !part.file && entity.role == EntityRole::publisher && entity.ported_as.name == "tzc::Publisher" &&
         only_calls_members(part.code, entity.name, members);
}

std::string UnseenUses::named_in(const Part& part, const Entity& entity) const {
  if (!may_name(part, entity)) return "";
  const std::string& text = texts_.at(entity.where.file);
  const std::size_t at = offset_of(text, entity.where.line, entity.where.column);
  const bool local = entity.storage == Storage::local || entity.storage == Storage::static_local,
             parameter = entity.storage == Storage::parameter;
  const std::string function = parameter ? function_around(text, at) : "";
  if (!function.empty() && part.words.count(function)) return function;
  if (entity.name.empty() || !part.words.count(entity.name) || fits_either_class(part, entity)) return "";
  if (!local && !parameter) return entity.name;
  const std::size_t end = local ? end_of_block(text, at) : end_of_function(text, at);
  const bool in_scope =
      part.where.file == entity.where.file && at < part.where.begin && part.where.begin < end;
  return in_scope ? entity.name : "";
}

/// Whether no unit compiles the part together with anything that the port changes there. One change elsewhere is enough for it to
/// count: code around both may call what either of them defines.
bool UnseenUses::lies_apart(const Part& part, const Edits& edits) const {
  if (part.kind != Kind::branch) return false;  // compiled as what stands around it is
  const ConditionalCode& code = conditional_.at(part.where.file);
  return std::all_of(edits.begin(), edits.end(), [&](const Edit& edit) {
    return edit.file == part.where.file && code.excludes({part.where.begin, part.where.end}, edit.offset);
  });
}

std::optional<Obstacle> UnseenUses::user_of(const Component& component, const Edits& edits) const {
  for (const Part& part : parts_) {
    if (lies_apart(part, edits)) continue;
    for (const Entity* entity : component.entities)
      if (std::optional<Obstacle> obstacle = use_of(*entity, part)) return obstacle;
  }
  return {};
}

std::optional<Obstacle> UnseenUses::use_of(const Entity& entity, const Part& part) const {
  static const std::map<Kind, std::string> names{
      {Kind::branch, "a preprocessor branch that is not compiled here"},
      {Kind::argument, "the argument of a macro, which drops it in this configuration,"},
      {Kind::file, "a file that is not analysed"}};
  if (const std::string name = named_in(part, entity); !name.empty())
    return Obstacle{codes::TZC3007, names.at(part.kind) + " names '" + name + "'", location_of(part.where)};
  return {};
}

std::map<ComponentId, Obstacle> UnseenUses::users_of(const Edits& edits) const {
  std::map<ComponentId, Edits> edited;
  for (const Edit& edit : edits)
    if (edit.component) edited[*edit.component].push_back(edit);
  std::map<ComponentId, Obstacle> found;
  if (parts_.empty()) return found;
  for (const Component& component : components_.all()) {
    const auto own = edited.find(component.id);
    if (own == edited.end()) continue;
    if (const std::optional<Obstacle> obstacle = user_of(component, own->second))
      found.emplace(component.id, *obstacle);
  }
  return found;
}

}  // namespace tzc::rewriter
