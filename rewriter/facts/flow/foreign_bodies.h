// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <map>
#include <set>

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
  bool is_looked_into(const clang::FunctionDecl* function) const;
  clang::QualType in(const clang::Stmt* stmt);
  clang::QualType by(const clang::Stmt* stmt);

  const Unit& unit_;
  std::map<const clang::FunctionDecl*, clang::QualType> known_;
};

}  // namespace tzc::rewriter
