// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Code of the package that libraries call without being given it: deleters that a shared pointer keeps, function objects
// that an object keeps, and virtual functions of library classes that the package overrides.

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include <set>
#include <string>

#include "facts/unit.h"

namespace tzc::rewriter {

/// What a unit shows of such code.
struct HiddenCode {
  bool deleters = false;             ///< a shared pointer is given code of the package to delete its object
  std::set<std::string> overridden;  ///< classes of libraries whose virtual functions the package overrides

  /// A call that may give a shared pointer a deleter.
  void note(const Unit& unit, clang::QualType object, llvm::ArrayRef<const clang::Expr*> arguments);
  void note(const Unit& unit, const clang::CXXRecordDecl* record);
};

/// Whether the end of an object of the type may run such code: a deleter, or the destructor of an object whose class the
/// type does not show.
bool may_release(const Unit& unit, const HiddenCode& hidden, clang::QualType type);
/// Whether an object of the type keeps function objects, which a library may have been given elsewhere: an observer.
bool may_call_back(clang::QualType type);
/// Whether a library that is given an object of the type may call what the package overrides.
bool may_dispatch(const Unit& unit, const HiddenCode& hidden, clang::QualType type);

}  // namespace tzc::rewriter
