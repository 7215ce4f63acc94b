// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/facts.h"

namespace tzc::rewriter {

/// Messages that are ported and made where nothing is allocated (AllocationSite). The first publish of one copies its elements, so a publish
/// that may have a new one each time is no zero_copy. It decides levels only, never whether a port is right.
///
/// Of what an object starts with, content_flow.h tells: the flow knows which messages are new by the name of the member, in the function that
/// publishes and in those that are given it. By any other name (a result, a queue, another member) the message may be another one each time.
class UnallocatedMessages {
 public:
  explicit UnallocatedMessages(const Facts& facts);

  /// None: what is published there is no such message, or the same one again.
  std::optional<Obstacle> why_copied(const Publish& fact) const;

 private:
  using Reached = std::map<EntityId, Obstacle>;  ///< what may be such a message, and why it is copied

  void follow(const EntityId& from, const Obstacle& why, Reached& reached) const;
  bool is_named_by_member(const Publish& fact) const;

  std::multimap<EntityId, EntityId> next_;  ///< what may be the same message afterwards
  Reached started_;
  std::set<std::string> members_;                        ///< that start with a message, by USR
  std::map<PublishPlace, std::set<std::string>> names_;  ///< the roots of what is published there
};

}  // namespace tzc::rewriter
