// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <vector>

#include "model/facts.h"

namespace tzc::rewriter {

/// Local messages that nothing but their own name leads to (AllocationSite::is_apart), and neither they nor their content come to a
/// publish: shared memory would gain them nothing. The facts must outlive it.
class Unpublished {
 public:
  explicit Unpublished(const Facts& facts);

  bool has(const EntityId& message) const { return messages_.count(message) != 0; }

 private:
  bool stays_apart(const EntityId& message) const;
  bool is_exchanged(const EntityId& parameter) const;
  std::vector<EntityId> next_to(const EntityId& entity) const;

  const Facts& facts_;
  std::multimap<EntityId, EntityId> to_, from_;  // flows
  std::set<EntityId> published_;
  std::set<std::string> exchanged_;  // roots of what exchanges its content with others
  std::set<EntityId> messages_;
};

}  // namespace tzc::rewriter
