// SPDX-License-Identifier: BSD-3-Clause
#include "solve/binding.h"

#include <algorithm>

#include "report/codes.h"

namespace tzc::rewriter {
namespace {

constexpr const char* nowhere = "it is built where its publisher can not be named";

}  // namespace

bool Binder::inherits(const std::string& record, const std::string& base) const {
  if (record.empty() || base.empty()) return false;
  if (record == base) return true;
  const auto bases = facts_.bases.find(record);
  return bases != facts_.bases.end() && std::any_of(bases->second.begin(), bases->second.end(),
                                                    [&](const std::string& b) { return inherits(b, base); });
}

bool Binder::visible(const Birth& birth, const Entity& publisher) const {
  if (publisher.home == Home::member) return inherits(birth.record, publisher.record);
  return publisher.home == Home::global && publisher.where.file == birth.where.file &&
         publisher.where.line < birth.where.line;
}

/// 2: the publisher is named together with the birth's message, 1: with one that has to have its type, 0:
/// neither.
int Binder::closeness(const PublisherName& name, const Birth& birth) const {
  if (std::count(name.messages.begin(), name.messages.end(), birth.entity) != 0) return 2;
  return std::any_of(name.messages.begin(), name.messages.end(), [&](const Key& message) {
    const Component* component = components_.of(message);
    return component && component->id == component_.id;
  });
}

std::optional<Solution::Bound> Binder::named_at(const Birth& birth) const {
  const auto bound = [&](const PublisherName& name) {
    const std::string guard = name.guarded ? "if (" + name.text + ") " : "";
    return Solution::Bound{&birth, name.pointer ? "*" + name.text : name.text,
                           guard + name.text + (name.pointer ? "->" : ".") + "allocate",
                           &facts_.entities.at(name.publisher)};
  };
  const bool takes_reference = !birth.changes.empty();  // to the publisher, which must be there
  // First one that is named together with this very message, then with what the message becomes.
  for (const int wanted : {2, 1, 0})
    for (const PublisherName& name : birth.publishers) {
      const Component* publisher = components_.of(name.publisher);
      if (publisher && publishers_.count(publisher->id) && closeness(name, birth) >= wanted &&
          !(name.guarded && takes_reference))
        return bound(name);
    }
  for (const int id : publishers_)
    for (const Entity* entity : components_.all()[static_cast<std::size_t>(id)].entities)
      if (visible(birth, *entity) && entity->plain) return bound({entity->key, entity->name});
  return {};
}

bool Binder::is_helper(const Birth& birth) const {
  const Component* result = components_.of(birth.function + "#r");
  return result && result->id == component_.id && facts_.helpers.count(birth.function) != 0;
}

/// A birth in a helper whose callers can name the publisher is bound to a parameter that it is given.
bool Binder::bind(const Birth& birth, Solution::Message& message) {
  if (!birth.calls.empty() && given_.count(birth.calls) == 0) return true;
  const bool possible = !birth.filled && (birth.at || (birth.adapter && !birth.changes.empty()));
  const auto named = possible ? named_at(birth) : std::nullopt;
  if (named) {
    births_.push_back(*named);
  } else if (possible && is_helper(birth)) {
    const std::string& name = facts_.helpers.at(birth.function).parameter;
    given_.insert(birth.function);
    births_.push_back({&birth, name, name + ".allocate", nullptr});
  } else {
    message.why_not = {birth.filled ? codes::TZC1020 : codes::TZC1019,
                       birth.filled ? "it starts as a copy of another message" : nowhere, birth.where};
    message.at = birth.entity;
    return false;
  }
  return true;
}

/// The parameter has one type, so all publishers must have it.
bool Binder::give_publishers(Solution::Message& message) {
  if (given_.empty()) return true;
  std::map<std::string, const Entity*> types;
  for (const Solution::Bound& bound : births_)
    if (bound.entity) types.emplace(bound.entity->ported_class, bound.entity);
  if (types.size() != 1) {
    message.why_not = {codes::TZC1019, nowhere, births_.front().birth->where};
    message.at = births_.front().birth->entity;
    return false;
  }
  const auto& [type, publisher] = *types.begin();
  for (const std::string& helper : given_)
    helpers_.push_back({helper, component_.entities[0]->key, type, publisher->ported_header});
  return true;
}

bool Binder::bind(const std::vector<const Birth*>& births, Solution::Message& message) {
  // A helper that is given the publisher makes its calls births, perhaps in another helper.
  for (std::size_t known = 1; known != given_.size() || births_.empty();) {
    known = given_.size();
    births_.clear();
    for (const Birth* birth : births)
      if (!bind(*birth, message)) return false;
    if (births_.empty()) {
      message.why_not = {codes::TZC1019, "where it is built was not found", component_.entities[0]->where};
      return false;
    }
  }
  return give_publishers(message);
}

}  // namespace tzc::rewriter
