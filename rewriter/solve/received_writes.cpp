// SPDX-License-Identifier: BSD-3-Clause
#include "solve/received_writes.h"

#include <algorithm>

#include "model/codes.h"
#include "model/erase_if.h"
#include "solve/array_origins.h"

namespace tzc::rewriter {
namespace {

/// Each transport of image_transport has a topic of its own. roscpp subscribes to a topic once, by the hints of the callback that comes
/// first, so one that asks for UDPROS may be given what another one shares.
bool has_another_topic(const Subscribe& site) {
  return !site.asked_transport.empty() && site.asked_transport != udpros;
}

}  // namespace

ReceivedWrites::ReceivedWrites(const Facts& facts) : facts_(facts) {
  for (const Flow& flow : facts.flows) {
    if (facts.objects.count(flow.to) == 0) next_.emplace(flow.from, flow.to);
    from_.emplace(flow.to, flow.from);
  }
  for (const auto& item : facts.subscribes)
    callbacks_.insert(item.second.callbacks.begin(), item.second.callbacks.end());
  for (const auto& item : facts.filter_callbacks)
    filtered_.insert(item.second.parameters.begin(), item.second.parameters.end());
}

/// Those of the class that subscribes, its bases and what derives from it; any, where the filter is handed on. What is registered with somebody
/// else's filter or synchronizer may be registered with this one.
std::vector<const FilterCallbackUse*> ReceivedWrites::registered(const Subscribe& site) const {
  if (site.filter.empty()) return {};
  const std::set<std::string> around = facts_.with_bases(site.scope);
  std::vector<const FilterCallbackUse*> own, all;
  for (const auto& [callback, use] : facts_.filter_callbacks) {
    if (callback.type != site.type && !callback.type.empty()) continue;
    all.push_back(&use);
    if (!callback.filter.empty() && callback.filter != site.filter) continue;  // another filter's own
    if (callback.scope == any_class || around.count(callback.scope) != 0 ||
        facts_.with_bases(callback.scope).count(site.scope) != 0)
      own.push_back(&use);
  }
  return own.empty() || next_.count(site.filter) != 0 ? all : own;
}

bool ReceivedWrites::takes_own(const Subscribe& site) const {
  const std::vector<const FilterCallbackUse*> uses = registered(site);
  return site.writes ||
         std::any_of(uses.begin(), uses.end(), [](const FilterCallbackUse* use) { return use->writes; });
}

bool ReceivedWrites::is_unknown(const Subscribe& site) const {
  const std::vector<const FilterCallbackUse*> uses = registered(site);
  return site.is_unknown ||
         std::any_of(uses.begin(), uses.end(), [](const FilterCallbackUse* use) { return use->is_unknown; });
}

/// The parameters that receive the message itself, and no copy that is their function's own.
std::vector<EntityId> ReceivedWrites::shown_to(const Subscribe& site) const {
  std::vector<EntityId> parameters = site.callbacks;
  for (const FilterCallbackUse* use : registered(site))
    parameters.insert(parameters.end(), use->parameters.begin(), use->parameters.end());
  erase_if(parameters, [&](const EntityId& parameter) {
    const auto known = facts_.own_parameters.find(parameter);
    return known != facts_.own_parameters.end() && known->second;
  });
  return parameters;
}

/// No callback sees the message itself: each has a copy to itself, or an object that is made from it.
bool ReceivedWrites::gives_copies_alone(const Subscribe& site) const {
  return (takes_own(site) || site.converts) && !is_unknown(site) && shown_to(site).empty();
}

/// Whether the code may run where the subscription is.
bool ReceivedWrites::meets(const Subscribe& site, const Location& code) const {
  return facts_.share_a_process(site.where.file, code.file);
}

std::set<EntityId> ReceivedWrites::received(const Subscribe& site) const {
  std::vector<EntityId> open = shown_to(site);
  std::set<EntityId> known;
  while (!open.empty()) {
    const EntityId one = open.back();
    open.pop_back();
    if (!known.insert(one).second) continue;
    const auto [begin, end] = next_.equal_range(one);
    for (auto next = begin; next != end; ++next) open.push_back(next->second);
  }
  return known;
}

std::optional<Obstacle> ReceivedWrites::write(const Subscribe& site, bool to_array) const {
  const std::set<EntityId> messages = received(site);
  for (const DataWrite& write : facts_.data_writes)
    if (write.to_array == to_array && messages.count(write.message) != 0 && meets(site, write.obstacle.where))
      return write.obstacle;
  return {};
}

std::optional<Obstacle> ReceivedWrites::to_message(const Subscribe& site) const {
  if (gives_copies_alone(site)) return {};
  for (const EntityId& key : received(site)) {
    const auto entity = facts_.entities.find(key);
    if (entity == facts_.entities.end()) continue;
    for (const Obstacle& obstacle : entity->second.obstacles)
      if (obstacle.code == codes::TZC2002 && meets(site, obstacle.where)) return obstacle;
  }
  if (const std::optional<Obstacle> array = write(site, true)) return array;
  if (const std::optional<Obstacle> array = untraced_write(site, true)) return array;
  if (const std::optional<Obstacle> array = array_cast(facts_, site)) return array;
  return untraced_cast(site);
}

/// A write through a message of unknown origin (kept in a library's object, bound, handed to a thread) counts against every subscription
/// of its type: all callbacks of a topic get one message, and any name may be remapped to the topic. Messages of known origin are
/// looked at by the other functions.
std::optional<Obstacle> ReceivedWrites::to_message_of_another(const Subscribe& site) const {
  for (const auto& item : facts_.subscribes) {
    const Subscribe& other = item.second;
    if (&other == &site || other.type != site.type || has_another_topic(other) ||
        !meets(site, location_of(other.where)))
      continue;
    if (std::optional<Obstacle> write = to_message(other)) {
      write->reason += ", by a callback of another subscription to its type, which may have the same topic";
      return write;
    }
  }
  return {};
}

bool ReceivedWrites::shares_with_one_that_takes_own(const Subscribe& site) const {
  return std::any_of(facts_.subscribes.begin(), facts_.subscribes.end(), [&](const auto& item) {
    const Subscribe& other = item.second;
    return other.type == site.type && site.topic && other.topic == site.topic &&
           meets(site, location_of(other.where)) && takes_own(other);
  });
}

std::optional<Obstacle> ReceivedWrites::untraced_cast(const Subscribe& site) const {
  for (const ConstCast& cast : facts_.const_casts) {
    std::set<EntityId> seen;
    const bool is_known =
        !cast.messages.empty() &&
        std::all_of(cast.messages.begin(), cast.messages.end(),
                    [&](const EntityId& message) { return is_traced(message, !site.filter.empty(), seen); });
    if (cast.type == site.type && !is_known && meets(site, cast.obstacle.where)) return cast.obstacle;
  }
  return {};
}

/// Whether all that the entity may name is known: callbacks' messages, those of filters where they are wanted, and objects of the package.
bool ReceivedWrites::is_traced(const EntityId& message, bool with_filters, std::set<EntityId>& seen) const {
  if (!seen.insert(message).second || callbacks_.count(message) != 0 || facts_.objects.count(message) != 0)
    return true;
  if (with_filters && filtered_.count(message) != 0) return true;
  const auto function = facts_.parameters.find(message);
  if (function != facts_.parameters.end() && facts_.addressed.count(function->second) != 0) return false;
  const auto [begin, end] = from_.equal_range(message);
  return begin != end && std::all_of(begin, end, [&](const auto& flow) {
           return is_traced(flow.second, with_filters, seen);
         });
}

/// Also counts writes through messages that were bound or handed to a thread, whose origin is not followed.
std::optional<Obstacle> ReceivedWrites::to_elements(const Subscribe& site) const {
  if (const std::optional<Obstacle> known = write(site, false)) return known;
  return untraced_write(site, false);
}

std::optional<Obstacle> ReceivedWrites::untraced_write(const Subscribe& site, bool to_array) const {
  for (const DataWrite& write : facts_.data_writes) {
    std::set<EntityId> seen;
    const auto message = facts_.entities.find(write.message);
    const bool is_of_type = message != facts_.entities.end() && message->second.type == site.type;
    if (write.to_array == to_array && is_of_type && meets(site, write.obstacle.where) &&
        !is_traced(write.message, true, seen))
      return write.obstacle;
  }
  return {};
}

}  // namespace tzc::rewriter
