// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <string>

#include "facts/flow/flow_sources.h"
#include "facts/syntax/unit.h"
#include "model/array_casts.h"

namespace tzc::rewriter {

/// Ways in which code may get an array to write to that was const: as those of messages (ValueFlow), by type, whatever the way that the array
/// takes to them.
class ArrayCastCollector {
 public:
  ArrayCastCollector(const Unit& unit, EntityTable& entities) : unit_(unit), sources_(unit, entities) {}

  void cast(const clang::CastExpr* cast);
  void member(const clang::MemberExpr* member);
  void variable_argument(const clang::VAArgExpr* argument);
  void call(const clang::CallExpr* call);
  const ArrayCastFacts& found() const { return found_; }

 private:
  struct Conversion {
    clang::QualType from, to;
    const clang::Expr* operand = nullptr;
  };
  void convert(const Conversion& conversion, bool removes_const, clang::SourceLocation where);
  void add(ArrayCast cast, clang::SourceLocation where);
  std::string origin(const clang::Expr* array, unsigned depth = 0);
  std::string origin_of_name(const clang::DeclRefExpr* name, unsigned depth);
  std::string origin_of_parameter(const clang::ParmVarDecl* parameter) const;
  std::string origin_of_member(const clang::MemberExpr* member);

  const Unit& unit_;
  SourceFinder sources_;
  ArrayCastFacts found_;
};

}  // namespace tzc::rewriter
