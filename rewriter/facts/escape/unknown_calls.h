// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "facts/escape/publish_events.h"

namespace tzc::rewriter {

/// Where a function may run code of the package that nothing names there: through a pointer or function object, or inside a
/// library that is not known to call nothing (known_functions.def). Immutable.
class UnknownCalls {
 public:
  explicit UnknownCalls(const std::vector<SeenEvent>& events);

  /// When the expression is evaluated; none: never.
  std::optional<IfShown> at(const clang::Stmt* expr) const { return found(calls_, expr); }
  /// When the variable, or a temporary that it is a reference to, ends; none: never.
  std::optional<IfShown> at_end_of(const clang::VarDecl* variable) const { return found(ends_, variable); }
  /// Where scopes end that Clang's control flow does not show: behind any statement, then (GCC's cleanup functions).
  bool at_end_of_scopes() const { return at_end_of_scopes_; }
  /// When the members and bases of the destructor's object end; none: never.
  std::optional<IfShown> at_end_of_parts(const clang::FunctionDecl* destructor) const {
    return at(destructor->getBody());
  }

 private:
  template <class Key>
  static std::optional<IfShown> found(const std::map<Key, IfShown>& calls, const Key& key) {
    const auto call = calls.find(key);
    return call == calls.end() ? std::nullopt : std::optional(call->second);
  }

  std::map<const clang::Stmt*, IfShown> calls_;
  std::map<const clang::VarDecl*, IfShown> ends_;
  bool at_end_of_scopes_ = false;
};

}  // namespace tzc::rewriter
