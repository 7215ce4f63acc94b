// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <vector>

#include "model/facts.h"

namespace tzc::rewriter {

/// Local messages whose content never comes to a publish, neither under their own name nor under another: shared memory would gain them
/// nothing. It decides levels only, never whether a port is right.
class Unpublished {
 public:
  explicit Unpublished(const Facts& facts);

  bool has(const EntityId& message) const { return messages_.count(message) != 0; }

 private:
  void read_contents(const Facts& facts);
  bool stays_apart(const AllocationSite& site) const;
  std::vector<EntityId> next_to(const EntityId& entity) const;

  const Facts& facts_;
  std::multimap<EntityId, EntityId> to_, from_;  // flows
  std::set<EntityId> published_;
  std::set<std::string> exchanged_;   // roots of what exchanges its content with others
  std::set<std::string> unfollowed_;  // types of messages that are used, and which they are is not known
  std::set<EntityId> messages_;
};

}  // namespace tzc::rewriter
