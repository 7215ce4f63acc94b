// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <string>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

enum class Calls { sizes, known };

/// A number that nothing but the program's own statements changes.
bool is_plain_number(clang::QualType type);

/// Looks at what stands behind the resize of a message's array: an expression whose value is a number that is no element of the
/// array, and whose evaluation changes nothing, runs no code of the package, and comes to its end. It is made of literals,
/// variables, fields and other arrays by their names. A pointer or a reference might lead to an element; what leads to an object of
/// a class that bytes cannot be does not.
class NumberValues {
 public:
  /// calls: functions that may be called, besides size() of other arrays, which a resize of this one leaves as they are.
  NumberValues(const Unit& unit, Calls calls) : unit_(unit), calls_(calls) {}

  bool is_number(const clang::Expr* expr) const;
  /// Names, fields and pointers that lead on, and nothing that runs code.
  bool is_path(const clang::Expr* expr) const;

 private:
  bool is_object(const clang::Expr* expr) const;
  bool is_field(const clang::MemberExpr* member) const;
  bool is_other_array(const clang::Expr* expr) const;
  bool is_element(const clang::Expr* expr) const;
  bool is_size(const clang::CXXMemberCallExpr* call) const;
  bool is_call(const clang::CallExpr* call) const;

  const Unit& unit_;
  const Calls calls_;
};

/// An integer that the compiler knows, in decimal digits, whatever names or macros write it.
std::optional<std::string> constant_integer(const Unit& unit, const clang::Expr* expr);

}  // namespace tzc::rewriter
