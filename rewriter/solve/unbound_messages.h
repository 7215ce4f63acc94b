// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "model/facts.h"

namespace tzc::rewriter {

/// Messages that no function makes (members, globals, static locals) have no allocate: their first publish binds them to
/// shared memory. One that is never published itself, but given away by value, fills ordinary memory each time, so that
/// the publish of what got its content copies. It decides levels only, never whether a port is right.
class UnboundMessages {
 public:
  explicit UnboundMessages(const Facts& facts);

  /// None: what is published there did not come from such a message.
  std::optional<Obstacle> why_copied(const SiteId& site) const;

 private:
  void read_contents();
  void add_what_is_passed();
  void add(const GivenMessage& given);
  void hand_on();
  bool is_bound(const MessagePart& message) const;

  const Facts& facts_;
  std::map<std::string, std::set<std::string>> given_;  ///< to parameters: what callers pass
  std::map<std::string, std::set<std::string>> names_;  ///< that were given to a message
  std::set<std::string> published_;                     ///< roots, also of parameters
  std::set<std::string> replaced_;                      ///< as a whole, by what may lie in shared memory
  std::map<std::string, Obstacle> unbound_;             ///< by what holds the content
};

}  // namespace tzc::rewriter
