// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/DeclCXX.h>
#include <clang/AST/ExprCXX.h>

#include <vector>

#include "facts/content/content_log.h"
#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// Reads which of the package's destructors run: where a variable's scope or a temporary's expression ends, by delete, or,
/// perhaps, inside what a library does to an object that holds others.
class EndedObjects {
 public:
  EndedObjects(const Unit& unit, ContentLog& log) : unit_(unit), log_(log) {}

  void look_at(const clang::Stmt* stmt);
  /// An object of the type ends.
  void object(clang::QualType type, clang::SourceLocation where);

 private:
  struct Ended {
    const clang::CXXDestructorDecl* destructor;
    bool perhaps;  ///< it is held by a library's object, such as a shared pointer
  };
  class Search;

  std::vector<Ended> ended_with(clang::QualType type, bool perhaps) const;
  void parts_of(clang::QualType object, clang::SourceLocation where);
  void add(const Ended& ended, bool perhaps, clang::SourceLocation where);

  const Unit& unit_;
  ContentLog& log_;
};

}  // namespace tzc::rewriter
