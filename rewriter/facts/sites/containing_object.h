// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>

namespace tzc::rewriter {

/// The local variable or parameter that a message is part of, and ends with, as `frame` in "frame->image". Null: there is none. What a
/// pointer or a reference to a member, a global or an element leads to lasts.
const clang::VarDecl* object_that_ends(const clang::Expr* message);

/// Likewise of a message that is an element of a member: `pair` in "pair.clouds[i]".
const clang::VarDecl* object_of_element_that_ends(const clang::Expr* message);

/// Whether the variable is made new where it is declared, without content: Frame frame; auto frame = make_shared<Frame>();
bool is_made_empty(const clang::VarDecl* object);

}  // namespace tzc::rewriter
