// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"
#include "solve/components.h"
#include "solve/site_index.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// Which publishers that keep their class have shared memory, after all is decided. The arguments must outlive it.
class AttachedTopics {
 public:
  AttachedTopics(const Facts& facts, const Components& components, const Solution& solution)
      : facts_(facts), components_(components), solution_(solution), sites_(facts, components) {}

  /// Whether the call attaches shared memory: tzc::publish(publisher, message).
  bool attaches(const Publish& site) const;
  /// Whether the advertise call is changed to attach shared memory, or was by an earlier run.
  bool is_attached(const Advertise& site) const;
  /// Whether each call that publishes a large message with it attaches shared memory.
  bool is_attached_by_calls(const EntityId& publisher) const;
  /// Whether the publisher has shared memory wherever the package advertises it.
  bool reach(const EntityId& publisher) const;
  /// The same for all objects of a library's class.
  bool reach_class(const std::string& library_class) const;

 private:
  bool ports_call(const SiteId& site) const;
  bool reach_made_by_library(const std::string& library_class) const;

  const Facts& facts_;
  const Components& components_;
  const Solution& solution_;
  SiteIndex sites_;
};

}  // namespace tzc::rewriter
