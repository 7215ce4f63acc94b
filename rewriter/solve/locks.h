// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>

#include "model/facts.h"

namespace tzc::rewriter {

/// Which functions of the packages may take a lock, or wait for another thread, over all units.
class Locks {
 public:
  explicit Locks(const Facts& facts) : facts_(facts) {}

  /// Whether one of these functions (USRs; "": one that is not seen) may, or what it calls.
  bool may_be_taken_in(const std::set<std::string>& functions);

 private:
  const std::set<std::string>& functions();

  const Facts& facts_;
  std::optional<std::set<std::string>> functions_;
};

}  // namespace tzc::rewriter
