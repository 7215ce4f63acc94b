// SPDX-License-Identifier: BSD-3-Clause
#include "solve/soundness.h"

#include <algorithm>

#include "model/codes.h"

namespace tzc::rewriter {

bool Soundness::is_in(const EntityId& key) const {
  const Component* component = components_.of(key);
  return component && component->id == component_->id;
}

bool Soundness::any_in(const std::set<EntityId>& keys) const {
  return std::any_of(keys.begin(), keys.end(), [&](const EntityId& key) { return is_in(key); });
}

/// A message that other functions can reach without being given it.
bool Soundness::outlives_scope(const Component& component) const {
  return std::any_of(component.entities.begin(), component.entities.end(), [&](const Entity* entity) {
    return facts_.lasting.count(entity->id) != 0 || entity->lasts();
  });
}

/// Functions that publish a message of the component, or call one that does.
const std::set<std::string>& Soundness::reaching(Reach reach) {
  std::optional<std::set<std::string>>& functions = reach == Reach::writes ? writing_ : publishing_;
  if (functions) return *functions;
  functions.emplace();
  for (std::size_t known = ~std::size_t{0}; known != functions->size();) {
    known = functions->size();
    for (const auto& [usr, events] : facts_.effects)
      if (functions->count(usr) == 0 && std::any_of(events.begin(), events.end(), [&](const PublishEvent& e) {
            return concerns(e, reach);
          }))
        functions->insert(usr);
  }
  return *functions;
}

/// What has no body in the package may do anything.
bool Soundness::may_reach(const std::string& function, Reach reach) {
  return reaching(reach).count(function) != 0 || facts_.effects.count(function) == 0;
}

bool Soundness::concerns(const PublishEvent& event, Reach reach) {
  const bool reaches = lasting_ || any_in(event.messages);
  switch (event.kind) {
    case PublishEvent::Kind::publish:
    case PublishEvent::Kind::exchange:
      return any_in(event.messages);
    case PublishEvent::Kind::write:
      return reach == Reach::writes && any_in(event.messages);
    case PublishEvent::Kind::call:
      return reaches && may_reach(event.callee, reach);
    case PublishEvent::Kind::unknown:
      return reaches;
  }
  return true;
}

bool Soundness::ends_loudly() {
  return lasting_ ||
         std::any_of(facts_.loud_tails.begin(), facts_.loud_tails.end(), [&](const LoudTail& tail) {
           return any_in(tail.event.messages) && concerns(tail.event, Reach::publishes);
         });
}

/// A cast that may find one of the messages by the address of something else, and then uses it as what it is not any more. What is found so
/// lies in another object, or its address was kept without its type. Each use of a local variable is followed, so nothing else knows its
/// address: one whose address goes where its type is lost has an obstacle of its own, and one that is given to an object's member is one
/// with that. So local messages are not meant; members, globals and what closures hold are.
const ConstCast* Soundness::cast_to(const Component& component) const {
  if (!lasting_) return nullptr;
  for (const ConstCast& cast : facts_.foreign_casts)
    for (const Entity* entity : component.entities)
      if (entity->type == cast.type && facts_.share_a_process(entity->where.file, cast.obstacle.where.file))
        return &cast;
  return nullptr;
}

std::optional<Soundness::Danger> Soundness::danger(const Component& component) {
  component_ = &component;
  lasting_ = outlives_scope(component);
  publishing_.reset();
  writing_.reset();
  for (const DataHold& hold : facts_.holds)
    if (is_in(hold.message) && concerns(hold.event, hold.read_only ? Reach::writes : Reach::publishes))
      return Danger{hold.obstacle, hold.message};
  for (const DataEscape& escape : facts_.escapes)
    if (is_in(escape.message) && (!escape.ends_with_scope || ends_loudly()))
      return Danger{escape.obstacle, escape.message};
  if (const ConstCast* cast = cast_to(component))
    return Danger{cast->obstacle, component.entities.front()->id};
  const ElementUse* use = concurrent_.of(component);
  if (!use) return {};
  return Danger{{codes::TZC1003,
                 "another thread may publish or read it while this function reads its elements: no lock that "
                 "both take keeps them apart",
                 use->where},
                use->message};
}

}  // namespace tzc::rewriter
