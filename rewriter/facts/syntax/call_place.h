// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where a call stands in the file. A macro that writes the call itself cannot be edited; one that writes an argument, or a part of
// one, keeps its spelling, and the edits stand around it.

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <string>
#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// Says of a site where it is.
void set_place(SiteFact& site, const Unit& unit, const clang::Expr* call);

/// The words in front of the arguments.
struct CallPlace {
  Place object;  ///< empty: `this` is implied
  Place head;    ///< from behind the object to the parenthesis that opens the arguments
};
/// None: a macro writes some of the words, or the parenthesis that closes the call.
std::optional<CallPlace> call_place(const Unit& unit, const clang::CXXMemberCallExpr* call);

/// An argument with the macros that write it. None: one of them also writes something in front of it or behind it.
std::optional<Place> argument_place(const Unit& unit, const clang::CallExpr* call, unsigned index);

/// Whether a macro writes the type that a call names: advertise<IMAGE>(...).
bool is_type_by_macro(const Unit& unit, const clang::CXXMemberCallExpr* call);

/// Why there is no place for a call, or for an argument of it.
std::string macro_reason(const Unit& unit, const clang::CXXMemberCallExpr* call, const std::string& name);

/// A call that replaces another: its name, the rule that asks for it, the header that declares it, or null.
struct Callee {
  std::string to;
  const char* rule;
  const char* header;
};
/// The edits that turn `object.method<T>(a)` into `to<T>(object, a, last)`; empty: they cannot be made.
std::vector<Change> receiver_first(const Unit& unit, const clang::CXXMemberCallExpr* call,
                                   const Callee& callee, const std::string& last = "");

/// The edits that turn `f(object, a)` into `object.method(a)`; empty: they cannot be made.
std::vector<Change> receiver_back(const Unit& unit, const clang::CallExpr* call, const Callee& method);

}  // namespace tzc::rewriter
