// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "facts/unit.h"

namespace tzc::rewriter {

/// What the expression that names a publisher is made of.
struct NameParts {
  std::vector<const clang::VarDecl*> locals;
  std::vector<const clang::ValueDecl*> all;
  std::set<std::string> steps;  ///< pointers and indices that it follows: "node_->", "pubs_[i]", "*pub"
  bool has_effects = false;
};

/// Follows a pointer or an index: what lies behind it need not be there at another time.
bool is_step(const clang::Stmt* stmt);
std::string step_text(Unit& unit, const clang::Stmt* step);

/// Whether the function takes the step whenever it comes to the offset: behind it, or before it and nothing
/// has changed since.
bool takes_step_anyway(Unit& unit, const NameParts& parts, const clang::Stmt* body, const std::string& step,
                       unsigned at);
/// Whether a lock is taken between two offsets of the function.
bool locks_between(Unit& unit, const NameParts& parts, const clang::Stmt* body, unsigned from, unsigned to);

}  // namespace tzc::rewriter
