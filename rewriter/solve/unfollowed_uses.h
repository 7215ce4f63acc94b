// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/content_flow.h"
#include "model/facts.h"
#include "solve/other_names.h"

namespace tzc::rewriter {

/// Uses of messages where nothing shows which message is meant: it may be any one of its type that something else may name.
class UnfollowedUses {
 public:
  explicit UnfollowedUses(const OtherNames& other_names) : other_names_(other_names) {}

  /// Something that a function does.
  void note(const std::string& function, const ContentEvent& event);
  /// What may use the message that is published there; none: nothing but what is followed.
  std::optional<Obstacle> why(const SiteId& site) const;

 private:
  bool is_of_function(const MessagePart& part) const;

  const OtherNames& other_names_;
  std::map<MessagePart, Location> any_;                            ///< by any_message
  std::map<std::string, std::map<MessagePart, Location>> any_in_;  ///< likewise, by the function around
  std::map<PublishPlace, std::set<std::string>>
      local_;  ///< what is published there is its functions' own; none: it is not
};

}  // namespace tzc::rewriter
