// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "model/facts.h"

namespace tzc::rewriter {

/// Who calls which functions, by USR; a call may run what overrides its callee, too.
class Callers {
 public:
  explicit Callers(const Facts& facts);

  /// Whether the caller knows more for what the callee knows.
  using Learn = std::function<bool(const std::string& caller, const std::string& callee)>;
  /// Lets callers learn from what they call, until none of them learns more.
  void learn(const Learn& learns) const;

 private:
  std::map<std::string, std::set<std::string>> callers_;
};

/// The functions that a call of this one may run as well.
const std::set<std::string>& overrides_of(const std::string& usr, const Facts& facts);

/// The call as one of a function that overrides the callee.
ContentEvent call_of_override(const ContentEvent& call, const std::string& function);

}  // namespace tzc::rewriter
