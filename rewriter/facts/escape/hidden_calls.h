// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Code of the package that libraries call without being given it (model/hidden_code.h), and function objects that an object
// keeps.

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include <map>
#include <optional>
#include <set>
#include <string>

#include "facts/syntax/unit.h"
#include "model/hidden_code.h"

namespace tzc::rewriter {

/// What one unit shows of such code, and where others' may run in it.
class HiddenCode {
 public:
  explicit HiddenCode(const Unit& unit) : unit_(unit) {}

  /// A call that may give a shared pointer a deleter.
  void note(clang::QualType object, llvm::ArrayRef<const clang::Expr*> arguments);
  void note(const clang::CXXRecordDecl* record);

  /// When the end of an object of the type runs such code: a deleter, or the destructor of an object whose class the type does
  /// not show; none: never.
  std::optional<IfShown> at_end_of(clang::QualType type) { return parts_of(type).at_end; }
  /// When a library that is given an object of the type calls what the package overrides; none: never.
  std::optional<IfShown> in_library_with(clang::QualType type) { return parts_of(type).in_library; }

  const std::set<std::string>& shown() const { return shown_; }

 private:
  /// What the classes that make up a type have to do with it.
  struct Parts {
    std::optional<IfShown> at_end, in_library;
  };
  const Parts& parts_of(clang::QualType type);

  const Unit& unit_;
  std::set<std::string> shown_;
  const IfShown if_deleter_{IfShown::Names{a_deleter}};
  std::map<const clang::Type*, Parts> parts_;
};

/// Whether an object of the type keeps function objects, which a library may have been given elsewhere: an observer.
bool may_call_back(clang::QualType type);

}  // namespace tzc::rewriter
