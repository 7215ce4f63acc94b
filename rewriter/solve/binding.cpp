// SPDX-License-Identifier: BSD-3-Clause
#include "solve/binding.h"

#include <algorithm>
#include <string>
#include <tuple>

#include "model/codes.h"

namespace tzc::rewriter {
namespace {

constexpr const char* copied = "it starts as a copy of another message";

bool is_filled(const AllocationSite& site) {
  const auto* inserted = std::get_if<InsertedAllocation>(&site.how);
  return inserted && inserted->has_content();
}

/// Whether there is a place for the edits that allocate.
bool is_possible(const AllocationSite& site) {
  if (const auto* inserted = std::get_if<InsertedAllocation>(&site.how))
    return inserted->at && (!inserted->filled || inserted->copy);
  if (const auto* adapter = std::get_if<AdapterAllocation>(&site.how)) return !adapter->changes.empty();
  return !std::get<FactoryAllocation>(site.how).changes.empty();
}

/// Why there is none where the message is made.
const char* no_place(const AllocationSite& site) {
  const auto* inserted = std::get_if<InsertedAllocation>(&site.how);
  if (!inserted) return "a macro writes the call that builds it";
  return inserted->object.empty() ? "it has no name where it is built"
                                  : "it is built in the head of a statement, or by a macro";
}

std::string call_of(const PublisherName& name) {
  const std::string guard = name.guarded ? "if (" + name.text + ") " : "";
  return guard + name.text + (name.pointer ? "->" : ".") + "allocate";
}

BoundAllocation bound(const AllocationSite& site, const PublisherName& name, const Entity* publisher) {
  return {&site, name.pointer ? "*" + name.text : name.text, {call_of(name)}, publisher};
}

BoundAllocation by_node(const AllocationSite& site) {
  return {&site, "tzc::Publisher()", {"tzc::allocate"}, nullptr, true};
}

/// Whether names of a namespace mean the same in another one.
bool lies_in(const std::string& scope, const std::string& outer) {
  return outer.empty() || scope == outer || scope.rfind(outer + "::", 0) == 0;
}

/// A template has one text for all its instances: where one of them can name no publisher, none does.
void unite_instances(std::vector<BoundAllocation>& allocations) {
  const auto place = [](const BoundAllocation& allocation) {
    const Location& where = allocation.site->where;
    return std::tie(where.file, where.line, where.column);
  };
  std::set<std::tuple<std::string, unsigned, unsigned>> of_node;
  for (const BoundAllocation& allocation : allocations)
    if (!allocation.entity && allocation.is_of_node) of_node.insert(place(allocation));
  for (BoundAllocation& allocation : allocations)
    if (of_node.count(place(allocation)) != 0) allocation = by_node(*allocation.site);
}

/// Of a message without an allocation site.
std::string why_not_found(const Component& component) {
  const std::vector<const Entity*>& entities = component.entities;
  const auto contained = std::find_if(entities.begin(), entities.end(),
                                      [](const Entity* entity) { return entity->form == Form::contained; });
  if (contained != entities.end())
    return "it is an element of '" + (*contained)->name + "', and nothing shows where that makes it";
  const bool is_given = std::all_of(entities.begin(), entities.end(), [](const Entity* entity) {
    return entity->storage == Storage::parameter;
  });
  return is_given ? "no call that gives '" + entities.front()->name + "' a message was found"
                  : "where it is built was not found";
}

}  // namespace

/// Whether a constructor's initializers, or default ones, reach the function.
bool Binder::runs_early(const std::string& function) {
  if (!early_) {
    early_ = facts_.early;
    for (std::size_t known = 0; known != early_->size();) {
      known = early_->size();
      for (const std::string& caller : std::set<std::string>(*early_)) {
        const auto effects = facts_.effects.find(caller);
        if (effects == facts_.effects.end()) continue;
        for (const PublishEvent& event : effects->second)
          if (!event.callee.empty()) early_->insert(event.callee);
      }
    }
  }
  return early_->count(function) != 0;
}

/// Whether a thread may change the publisher while others wait for a lock: who does not hold it may not look at it.
bool Binder::may_change_under_lock(ComponentId publisher) const {
  return !facts_.locking.empty() &&
         std::any_of(facts_.changing.begin(), facts_.changing.end(), [&](const EntityId& entity) {
           const Component* component = components_.of(entity);
           return component && component->id == publisher;
         });
}

/// A member, in a function that runs before the members of its object are all there.
bool Binder::may_be_missing(const AllocationSite& site, const Entity& publisher) {
  const std::string& result = site.function.text();  // the function's USR and "#r"
  return publisher.storage == Storage::member && runs_early(result.substr(0, result.rfind('#')));
}

bool Binder::visible(const AllocationSite& site, const Entity& publisher) {
  if (site.unnameable.count(publisher.id) != 0 || may_be_missing(site, publisher)) return false;
  const MemberOf& member = publisher.member_of;
  if (publisher.storage == Storage::member)
    return !site.record.empty() && !member.record.empty() &&
           (member.is_private ? site.record == member.record
                              : facts_.with_bases(site.record).count(member.record) != 0);
  return publisher.storage == Storage::global && publisher.where.file == site.where.file &&
         publisher.where.line < site.where.line && lies_in(site.scope, member.scope);
}

/// 2: the publisher is named together with the site's message, 1: with one that has to have its type, 0: neither.
int Binder::closeness(const PublisherName& name, const AllocationSite& site) const {
  if (std::count(name.messages.begin(), name.messages.end(), site.entity) != 0) return 2;
  return std::any_of(name.messages.begin(), name.messages.end(), [&](const EntityId& message) {
    const Component* component = components_.of(message);
    return component && component->id == component_.id;
  });
}

/// Whether a publisher of the message may be named so where the message is built.
bool Binder::is_nameable(const PublisherName& name, const AllocationSite& site) {
  const Component* publisher = components_.of(name.publisher);
  // An adapter or a factory takes a reference to the publisher, which must be there.
  const bool takes_reference = !std::holds_alternative<InsertedAllocation>(site.how);
  return publisher && senders_.ported.count(publisher->id) && !(name.guarded && takes_reference) &&
         !may_wait(name) && !may_be_missing(site, facts_.entities.at(name.publisher));
}

/// By one that is there, if there is one: memory of any publisher serves them all. By several pointers that may be null: by the first
/// one that is not; and by the node if all are, and another publisher may send the message.
std::optional<BoundAllocation> Binder::named_at(const AllocationSite& site, int wanted) {
  std::optional<BoundAllocation> by_pointers;
  std::set<std::string> guards;
  std::set<ComponentId> others = senders_.ported;
  for (const PublisherName& name : site.publishers) {
    if (closeness(name, site) < wanted || !is_nameable(name, site)) continue;
    const Entity* publisher = &facts_.entities.at(name.publisher);
    if (!name.guarded) return bound(site, name, publisher);
    others.erase(components_.of(name.publisher)->id);
    if (!guards.insert(name.text).second) continue;
    if (by_pointers)
      by_pointers->calls.push_back(call_of(name));
    else
      by_pointers = bound(site, name, publisher);
  }
  if (by_pointers && (senders_.has_kept || !others.empty())) {
    by_pointers->calls.emplace_back("tzc::allocate");
    by_pointers->is_of_node = true;
  }
  return by_pointers;
}

std::optional<BoundAllocation> Binder::available_at(const AllocationSite& site) {
  // Prefers a publisher that is named together with this message, then one named with what the message
  // becomes.
  for (const int wanted : {2, 1, 0})
    if (std::optional<BoundAllocation> named = named_at(site, wanted)) return named;
  for (const ComponentId id : senders_.ported)
    for (const Entity* entity : components_[id].entities)
      if (entity->form == Form::itself && visible(site, *entity) && !may_change_under_lock(id))
        return bound(site, {entity->id, entity->name, false, false, {}, {}}, entity);
  return {};
}

bool Binder::may_wait(const PublisherName& name) {
  return locks_.may_be_taken_in(name.callees);
}

bool Binder::is_in_factory(const AllocationSite& site) const {
  const Component* result = components_.of(site.function);
  return result && result->id == component_.id && facts_.factories.count(site.function) != 0;
}

/// Nothing is allocated there, and the message is ported all the same: its first publish binds it. A copy can be made of another ported message
/// as it stands; of a stock one it cannot, unless a constructor is named for it. It is worth it where the other one is published itself.
bool Binder::goes_without(const AllocationSite& site) const {
  const std::vector<EntityId>& originals = site.copied_from;
  return site.start || (is_filled(site) && !originals.empty() &&
                        std::all_of(originals.begin(), originals.end(), [&](const EntityId& original) {
                          const Component* component = components_.of(original);
                          return component && component->id == component_.id && is_published(original);
                        }));
}

bool Binder::is_published(const EntityId& message) const {
  return std::any_of(facts_.publishes.begin(), facts_.publishes.end(), [&](const auto& publish) {
    const std::vector<EntityId>& messages = publish.second.messages;
    return std::count(messages.begin(), messages.end(), message) != 0;
  });
}

/// Why nothing can be allocated there, whoever gives the memory.
std::optional<Decision> Binder::obstacle_at(const AllocationSite& site) const {
  if (goes_without(site)) return {};
  if (!site.refusal.empty()) return refused({codes::TZC1019, site.refusal, site.where}, site.entity);
  if (is_possible(site) || std::holds_alternative<FactoryAllocation>(site.how)) return {};
  if (is_filled(site)) return refused({codes::TZC1020, copied, site.where}, site.entity);
  return refused({codes::TZC1019, no_place(site), site.where}, site.entity);
}

/// A site in a factory whose callers can name the publisher is bound to a parameter that the factory is given.
void Binder::bind(const AllocationSite& site) {
  const std::optional<BoundAllocation> publisher = is_possible(site) ? available_at(site) : std::nullopt;
  if (publisher) {
    allocations_.push_back(*publisher);
  } else if (by_node_) {
    allocations_.push_back(by_node(site));
  } else if (is_possible(site) && is_in_factory(site)) {
    const std::string& name = facts_.factories.at(site.function).parameter;
    given_.insert(site.function);
    allocations_.push_back({&site, name, {name + ".allocate"}, nullptr});
  } else {
    lacks_publisher_ = true;
  }
}

/// The parameter has one type, so all publishers must have it.
void Binder::give_publishers() {
  if (given_.empty()) return;
  std::map<std::string, const Entity*> types;
  for (const BoundAllocation& allocation : allocations_)
    if (allocation.entity) types.emplace(allocation.entity->ported_as.name, allocation.entity);
  if (types.size() != 1) {
    lacks_publisher_ = true;
    return;
  }
  for (const EntityId& factory : given_)
    factories_.push_back({factory, component_.entities[0]->id, types.begin()->second->ported_as});
}

std::optional<Decision> Binder::bind(const std::vector<const AllocationSite*>& sites) {
  for (const AllocationSite* site : sites)
    if (std::optional<Decision> obstacle = obstacle_at(*site)) return obstacle;
  bind_all(sites);
  if (lacks_publisher_) {
    // Any publisher of the process can send what lies in shared memory of the node.
    by_node_ = true;
    given_.clear();
    factories_.clear();
    bind_all(sites);
  }
  if (!allocations_.empty() || component_.has_lasting_message()) return {};
  const auto copy =
      std::find_if(sites.begin(), sites.end(), [](const AllocationSite* site) { return is_filled(*site); });
  return copy == sites.end()
             ? refused({codes::TZC1019, why_not_found(component_), component_.entities[0]->where})
             : refused({codes::TZC1020, copied, (*copy)->where}, (*copy)->entity);
}

void Binder::bind_all(const std::vector<const AllocationSite*>& sites) {
  // The calls of a factory that is given the publisher become allocation sites, perhaps in another factory.
  for (std::size_t known = ~std::size_t{0}; known != given_.size();) {
    known = given_.size();
    allocations_.clear();
    for (const AllocationSite* site : sites) {
      const auto* call = std::get_if<FactoryAllocation>(&site->how);
      if (!goes_without(*site) && (!call || given_.count(call->factory) != 0)) bind(*site);
    }
  }
  unite_instances(allocations_);
  give_publishers();
}

}  // namespace tzc::rewriter
