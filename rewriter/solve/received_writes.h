// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "model/facts.h"

namespace tzc::rewriter {

/// What callbacks do with the messages that they receive as const. A copy of such a message is their own.
class ReceivedWrites {
 public:
  explicit ReceivedWrites(const Facts& facts);

  /// A callback takes the message by value or as its own.
  bool takes_own(const Subscribe& site) const;
  /// A callback is not known: it may do with the message what its type allows.
  bool is_unknown(const Subscribe& site) const;
  /// A callback of the same topic takes the message as its own, so that all get copies.
  bool shares_with_one_that_takes_own(const Subscribe& site) const;
  /// The message itself, or one of its arrays, is made writable: it could be resized. None: it is not.
  std::optional<Obstacle> to_message(const Subscribe& site) const;
  /// The same by a callback of another subscription that may have the same topic.
  std::optional<Obstacle> to_message_of_another(const Subscribe& site) const;
  /// Elements of its arrays may be written to. None: they are not.
  std::optional<Obstacle> to_elements(const Subscribe& site) const;

 private:
  std::vector<const FilterCallbackUse*> registered(const Subscribe& site) const;
  std::vector<EntityId> shown_to(const Subscribe& site) const;
  bool gives_copies_alone(const Subscribe& site) const;
  bool meets(const Subscribe& site, const Location& code) const;
  std::set<EntityId> received(const Subscribe& site) const;
  std::optional<Obstacle> write(const Subscribe& site, bool to_array) const;
  std::optional<Obstacle> untraced_write(const Subscribe& site, bool to_array) const;
  std::optional<Obstacle> untraced_cast(const Subscribe& site) const;
  bool is_traced(const EntityId& message, bool with_filters, std::set<EntityId>& seen) const;

  const Facts& facts_;
  std::multimap<EntityId, EntityId> next_;   ///< where the same message is known by another name
  std::multimap<EntityId, EntityId> from_;   ///< where a message comes from
  std::set<EntityId> callbacks_, filtered_;  ///< parameters of callbacks of subscriptions, of filters
};

}  // namespace tzc::rewriter
