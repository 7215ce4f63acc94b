// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/ExprCXX.h>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// What deletes a message that a shared pointer is given as a raw one: ImagePtr(new Image, deleter), image.reset(new Image, deleter).
struct Deleter {
  const clang::Expr* given = nullptr;  ///< null: the pointer is given none
  const clang::FunctionDecl* function =
      nullptr;  ///< of the package, a generic one as it is written; null: a library's, or not known
  bool is_generic = false;  ///< takes what it is given, whatever its type
};
Deleter deleter_of(const Unit& unit, const clang::CXXConstructExpr* pointer);
Deleter deleter_of(const Unit& unit, const clang::CXXMemberCallExpr* reset);

/// Whether all that a deleter does is to delete what it is given. Whatever else it did (count, signal, put the message into a pool) would
/// show when nobody holds the message any more, and a ported publish may keep no pointer where the stock one does.
bool only_deletes(const Deleter& deleter);

/// Whether a call or construction gives such a pointer a generic deleter that does nothing else: it has nothing to ask the message for.
bool has_generic_deleter(const Unit& unit, const clang::Expr* call);

/// Whether a function of the package, or a closure, is named only to be the deleter of a message and does nothing else: the library that
/// calls it has nothing to give to it but the message that the pointer was given.
bool is_named_as_deleter(const Unit& unit, const clang::Expr* name);

}  // namespace tzc::rewriter
