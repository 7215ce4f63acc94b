// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What is private in an exported header may still reach code of other packages.

#include <clang/AST/Expr.h>

#include <set>
#include <string>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// The friends of the class of a private member, by USR; "" for one that has none. Empty for what no exported header declares.
std::set<std::string> friends_of(const Unit& unit, const clang::Decl* member);

/// Whether the function or variable is found by a name that does not tell its types, and that others are meant to find: it has C linkage,
/// or its declaration says what its symbol is. A caller that was compiled for other types is linked, and so is what dlsym() gives.
bool has_symbol_without_types(const clang::DeclaratorDecl* decl);

/// Whether the mention stands in a template of an exported header, in an expression that only its instantiation resolves: who
/// instantiates it says what the message, its array or the publisher is given to.
bool is_given_to_users(const Unit& unit, const clang::Expr* mention);

}  // namespace tzc::rewriter
