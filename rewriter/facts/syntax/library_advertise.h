// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Base classes and functions of libraries that advertise for the package and return the publisher. The library
// keeps its own copy; shared memory is attached to the topic beside it. What the package's own exported headers declare stays as it is,
// and counts as a library's.

#include <clang/AST/Expr.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// The rule for a call of a library's function that advertises for the package; null: it is none.
const LibraryAdvertise* library_advertise_rule(const Unit& unit, const clang::CallExpr* call);
/// Whether the function is such a one of the package itself.
bool advertises_for_callers(const Unit& unit, const clang::FunctionDecl* function);
/// The template arguments as written: M of advertise<M>(...).
llvm::ArrayRef<clang::TemplateArgumentLoc> written_arguments_of(const clang::CallExpr* call);
/// M of advertise<M>(...), when that is what a library can advertise; null otherwise.
clang::QualType library_advertised_type(const clang::CallExpr* call);
/// The call of `to` that an earlier run has put around it; null: none.
const clang::CallExpr* attaching_call(const Unit& unit, const clang::CallExpr* call, const std::string& to);
/// tzc::attach_publisher<M>(...), as a rule writes it.
bool attaches_publisher(const Unit& unit, const clang::CallExpr* call);

}  // namespace tzc::rewriter
