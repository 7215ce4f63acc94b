// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/content_flow.h"
#include "model/facts.h"
#include "solve/other_names.h"

namespace tzc::rewriter {

/// Whether what an entity names gets its tzc:: type.
using IsTwin = std::function<bool(const EntityId&)>;
inline bool any_is_twin(const EntityId&) {
  return true;
}

/// Uses of messages where nothing shows which message is meant: it may be any one of its type that something else may name, in the
/// same program. C++ lets an expression of a stock type denote no message of a tzc:: type, which is another class, so a use by what stays
/// a stock message means none that is ported.
class UnfollowedUses {
 public:
  UnfollowedUses(const Facts& facts, const OtherNames& other_names, IsTwin is_twin)
      : facts_(facts), other_names_(other_names), is_twin_(std::move(is_twin)) {}

  /// Something that a function does.
  void note(const std::string& function, const ContentEvent& event);
  /// What may use the message that is published there; none: nothing but what is followed.
  std::optional<Obstacle> why(const SiteId& site) const;

 private:
  using Uses = std::map<MessagePart, std::vector<Location>>;  ///< by any_message

  bool is_of_function(const MessagePart& part) const;
  bool may_be_twin(const ContentEvent& any) const;
  std::optional<Obstacle> obstacle_in(const Uses& uses, const SiteId& site) const;

  const Facts& facts_;
  const OtherNames& other_names_;
  const IsTwin is_twin_;
  Uses any_;
  std::map<std::string, Uses> any_in_;  ///< likewise, by the function around
  std::map<PublishPlace, std::set<std::string>>
      local_;  ///< what is published there is its functions' own; none: it is not
};

}  // namespace tzc::rewriter
