// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <string>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// An array of a message behind its resize.
struct ResizedArray {
  std::string name;           ///< as the resize writes it, without white space
  const clang::Expr* object;  ///< the same
  const clang::Expr* size;    ///< the argument of resize
  bool is_fresh;              ///< nothing has run since but resizes of sister arrays
};

/// scan.intensities.resize(n), behind scan.ranges.resize(n): it leaves what the size is made of alone, and comes back.
bool resizes_sister(const Unit& unit, const clang::Stmt* statement, const ResizedArray& array);

/// Whether the statement is a loop that gives each element a value, reads none, comes to its end, and runs no other code.
bool writes_each_element(const Unit& unit, const clang::Stmt* statement, const ResizedArray& array);

}  // namespace tzc::rewriter
