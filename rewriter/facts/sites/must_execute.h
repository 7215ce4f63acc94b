// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Whether every path of a function through a place also follows a pointer or an index.

#include <clang/AST/ExprCXX.h>

#include <set>
#include <string>

#include "facts/sites/name_reads.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Follows a pointer or an index, or divides: what may be invalid at another time.
bool is_step(const clang::Stmt* stmt);
std::string step_text(const Unit& unit, const clang::Stmt* step);

/// Where code may wait for other threads.
struct Waits {
  bool locks = false;
  std::set<std::string>
      callees;  ///< functions of the package that are called, by USR; "": one that is not seen
};

/// What the body of a function does on every path through an offset. `parts` and `body` must outlive it.
class MustExecute {
 public:
  MustExecute(const Unit& unit, const NameParts& parts, const clang::Stmt* body)
      : unit_(unit), parts_(parts), body_(body), reads_(unit, parts, body) {}

  /// Whether every path through the offset takes the step: behind it, or before it with no change since.
  bool takes(const std::string& step, unsigned at) const;
  /// Whether code that is seen may give the name another meaning between two offsets.
  bool changes_between(unsigned from, unsigned to) const;
  /// Whether any code may.
  bool may_change_between(unsigned from, unsigned to) const;
  /// Where another thread may be waited for, or let go on, between two offsets.
  Waits waits_between(unsigned from, unsigned to) const;

 private:
  const Unit& unit_;
  const NameParts& parts_;
  const clang::Stmt* body_;
  NameReads reads_;
};

}  // namespace tzc::rewriter
