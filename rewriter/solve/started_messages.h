// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/facts.h"

namespace tzc::rewriter {

/// Messages that a member pointer starts with, which are ported without an allocate (AllocationSite). The first publish of one copies its
/// elements. By the name of the member, in the function that publishes and in those that are given it, the content flow knows which are new
/// (content_flow.h). By any other name (a result, a queue, another member) each may be a new one, and nothing would tell: such a message is not
/// ported.
class StartedMessages {
 public:
  explicit StartedMessages(const Facts& facts);

  /// None: what is published there is no such message, or is named by its member.
  std::optional<Obstacle> given_away(const Publish& fact) const;

 private:
  void follow(const AllocationSite& start);
  bool is_named_by_member(const Publish& fact) const;

  std::multimap<EntityId, EntityId> next_;               ///< what may be the same message afterwards
  std::map<EntityId, const AllocationSite*> started_;    ///< what may be such a message
  std::set<std::string> members_;                        ///< that start with a message, by USR
  std::map<PublishPlace, std::set<std::string>> names_;  ///< the roots of what is published there
};

}  // namespace tzc::rewriter
