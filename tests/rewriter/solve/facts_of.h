// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"

namespace tzc::rewriter::test {

inline EntityId id(const std::string& name) {
  return EntityId(name);
}

inline Entity entity(const std::string& name, EntityRole role, Storage storage = Storage::local) {
  Entity entity;
  entity.id = id(name);
  entity.name = name;
  entity.role = role;
  entity.storage = storage;
  entity.where = {"/p/node.cpp", 1, 1};
  entity.form = Form::itself;
  if (role == EntityRole::publisher) entity.ported_as = {"tzc::Publisher", "tzc/ros.h"};
  return entity;
}

/// Facts by hand, as a node that advertises, makes a message and publishes it has them.
class FactsBuilder {
 public:
  Facts facts;

  FactsBuilder& add(const Entity& entity) {
    facts.entities.emplace(entity.id, entity);
    return *this;
  }
  FactsBuilder& flow(const std::string& from, const std::string& to, unsigned line = 1) {
    facts.flows.push_back({id(from), id(to), {"/p/node.cpp", line, 1}, from + " to " + to, false, {}});
    return *this;
  }
  FactsBuilder& obstacle(const std::string& entity, const std::string& code) {
    facts.entities.at(id(entity)).obstacles.push_back({code, "reason of " + code, {"/p/node.cpp", 9, 1}});
    return *this;
  }
  FactsBuilder& advertise(const std::string& publisher) {
    Advertise site;
    fill(site);
    site.publisher = id(publisher);
    site.topic = "image";
    site.rule = "advertise";
    facts.advertises.emplace(site.id(), site);
    return *this;
  }
  FactsBuilder& publish(const std::string& publisher, const std::string& message) {
    Publish site;
    fill(site);
    site.publisher = id(publisher);
    site.messages = {id(message)};
    facts.publishes.emplace(site.id(), site);
    facts.data_uses.push_back({id(message), {"/p/node.cpp", 3, 1}});
    return *this;
  }
  FactsBuilder& subscribe(const std::string& callback) {
    Subscribe site;
    fill(site);
    if (!callback.empty()) site.callbacks = {id(callback)};
    site.rule = "subscribe";
    site.changes = {{site.where, "tzc::subscribe(", "subscribe", {"tzc/ros.h"}}};
    facts.subscribes.emplace(site.id(), site);
    return *this;
  }
  /// A local message behind whose declaration `publisher` is available.
  FactsBuilder& allocation(const std::string& message, const std::string& publisher) {
    AllocationSite site;
    site.entity = id(message);
    InsertedAllocation how;
    how.at = Place{"/p/node.cpp", next_, next_, 3, 1};
    how.object = message;
    site.how = how;
    site.where = {"/p/node.cpp", 3, 1};
    if (!publisher.empty()) site.publishers = {{id(publisher), publisher, false, false, {id(message)}, {}}};
    facts.allocations.push_back(site);
    return *this;
  }

 private:
  void fill(SiteFact& site) {
    site.where = {"/p/node.cpp", next_, next_ + 5, next_, 1};
    next_ += 10;
    site.function = "main";
    site.type = "sensor_msgs/Image";
  }
  unsigned next_ = 10;
};

/// pub = nh.advertise<Image>("image", 1); Image image; ... pub.publish(image);
inline FactsBuilder camera() {
  return FactsBuilder()
      .add(entity("pub", EntityRole::publisher))
      .add(entity("image", EntityRole::message))
      .advertise("pub")
      .allocation("image", "pub")
      .publish("pub", "image");
}

}  // namespace tzc::rewriter::test
