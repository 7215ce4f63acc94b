// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Code of the package that libraries call without being given it: deleters that a shared pointer keeps, function objects
// that an object keeps, and virtual functions of library classes that the package overrides.

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include <map>
#include <set>
#include <string>

#include "facts/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// Such code, as far as one unit shows it or another one has shown it.
class HiddenCode {
 public:
  explicit HiddenCode(const Unit& unit) : unit_(unit), shown_(unit.hidden) {}

  /// A call that may give a shared pointer a deleter.
  void note(clang::QualType object, llvm::ArrayRef<const clang::Expr*> arguments);
  void note(const clang::CXXRecordDecl* record);

  /// Whether the end of an object of the type may run such code: a deleter, or the destructor of an object whose class the
  /// type does not show.
  bool may_release(clang::QualType type);
  /// Whether a library that is given an object of the type may call what the package overrides.
  bool may_dispatch(clang::QualType type);

  HiddenFacts found() const { return {shown_, missed_}; }

 private:
  /// What the classes that make up a type have to do with it.
  struct Parts {
    bool erased = false, deleters = false;
    std::set<std::string> polymorphic;  ///< classes of libraries
  };
  const Parts& parts_of(clang::QualType type);
  bool is_shown(const std::string& what);

  const Unit& unit_;
  std::set<std::string> shown_, missed_;
  std::map<const clang::Type*, Parts> parts_;
};

/// Whether an object of the type keeps function objects, which a library may have been given elsewhere: an observer.
bool may_call_back(clang::QualType type);

}  // namespace tzc::rewriter
