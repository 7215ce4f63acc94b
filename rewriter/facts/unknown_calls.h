// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <vector>

#include "facts/publish_events.h"

namespace tzc::rewriter {

/// Where a function may run code of the package that nothing names there: through a pointer or function object, or inside a
/// library that is not known to call nothing (known_functions.def). Immutable.
class UnknownCalls {
 public:
  explicit UnknownCalls(const std::vector<SeenEvent>& events);

  /// When the expression is evaluated.
  bool at(const clang::Stmt* expr) const { return calls_.count(expr) != 0; }
  /// When the variable, or a temporary that it is a reference to, ends.
  bool at_end_of(const clang::VarDecl* variable) const { return ends_.count(variable) != 0; }
  /// Where scopes end that Clang's control flow does not show: behind any statement, then (GCC's cleanup functions).
  bool at_end_of_scopes() const { return at_end_of_scopes_; }
  /// When the members and bases of the destructor's object end.
  bool at_end_of_parts(const clang::FunctionDecl* destructor) const { return at(destructor->getBody()); }

 private:
  std::set<const clang::Stmt*> calls_;
  std::set<const clang::VarDecl*> ends_;
  bool at_end_of_scopes_ = false;
};

}  // namespace tzc::rewriter
