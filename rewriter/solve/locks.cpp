// SPDX-License-Identifier: BSD-3-Clause
#include "solve/locks.h"

#include <algorithm>

namespace tzc::rewriter {

/// Those in whose bodies a lock is taken, and all from which calls lead to one.
const std::set<std::string>& Locks::functions() {
  if (functions_) return *functions_;
  functions_ = facts_.locking;
  const auto leads_to_one = [&](const PublishEvent& event) { return functions_->count(event.callee) != 0; };
  for (std::size_t known = ~std::size_t{0}; known != functions_->size();) {
    known = functions_->size();
    for (const auto& [usr, events] : facts_.effects)
      if (std::any_of(events.begin(), events.end(), leads_to_one)) functions_->insert(usr);
  }
  return *functions_;
}

bool Locks::may_be_taken_in(const std::set<std::string>& functions) {
  return std::any_of(functions.begin(), functions.end(), [&](const std::string& function) {
    return function.empty() || this->functions().count(function) != 0;
  });
}

}  // namespace tzc::rewriter
