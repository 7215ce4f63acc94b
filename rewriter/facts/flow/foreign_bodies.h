// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <set>
#include <vector>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Functions of other packages whose bodies the unit has: inline ones, and instances of templates, which no text of the other
/// package shows. Which of them cast the const of a message away, themselves or through others. Libraries of the system and of ROS are left
/// out: they do not resize what they are given as const, and where roscpp gives a message out to be written to, it copies it.
class ForeignBodies {
 public:
  explicit ForeignBodies(const Unit& unit) : unit_(unit) {}

  /// The message, as the cast names it; null: the function casts none, or is not seen here.
  clang::QualType loses_const(const clang::FunctionDecl* function);

 private:
  using Functions = std::vector<const clang::FunctionDecl*>;
  bool is_looked_into(const clang::FunctionDecl* function) const;
  /// Adds the functions that are called there.
  clang::QualType in_body(const clang::FunctionDecl* function, Functions& called) const;
  clang::QualType in(const clang::Stmt* stmt, Functions& called) const;
  clang::QualType by(const clang::Stmt* stmt, Functions& called) const;

  const Unit& unit_;
  std::set<const clang::FunctionDecl*> harmless_;  ///< that were looked into, and what they call
};

}  // namespace tzc::rewriter
