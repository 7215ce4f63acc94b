// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Messages that are made as copies of others: `M out = *in;`, `make_shared<M>(*in)`. The copy is another object with elements of
// its own, so it may be ported while the other one stays as it is: it starts empty and is assigned.

#include <clang/AST/Decl.h>
#include <clang/AST/Expr.h>

#include <optional>
#include <vector>

#include "facts/syntax/unit.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// What a message is copied from that starts so: `M out = *in;`, `M out = M(*in);`. Null: it starts otherwise.
const clang::Expr* copied_by(const clang::Expr* initializer);

/// `Image image = *cv_image.toImageMsg();` with a move in place of the copy: the pointer ends with the statement, and nobody else has one.
/// Empty: a message does not start so, or a macro writes it.
std::vector<Change> move_out_of_result(const Unit& unit, const clang::Expr* initializer);

/// Of a local variable. None: it does not start as a copy, or cannot be written otherwise (const, several variables, the head of a statement, a macro, a pack of
/// arguments, a type in the initializer that is ported, too, `auto` that means another type in each instance of a template).
std::optional<LaterCopy> later_copy(const Unit& unit, const clang::VarDecl* variable);

/// Whether new or make_shared makes the object as a copy of another message.
bool copies_message(const clang::Expr* made);

/// Of `MPtr out(new M(*in));`, `auto out = make_shared<M>(*in);`, likewise. An assignment, `out = make_shared<M>(*out)`, is none: the message that
/// is copied may end with it, other code may see the new one before it has its content, and the old one stays when copying throws.
std::optional<LaterCopy> later_copy(const Unit& unit, const clang::VarDecl* variable,
                                    const clang::Expr* made);

/// Whether the variable, a message or a pointer to one, starts as a copy that one of these writes otherwise, into memory that is allocated.
bool has_memory_for_copy(const Unit& unit, const clang::VarDecl* variable);

/// The message that new or make_shared makes the object from: M(std::move(other)), or a call that returns one. Null: none.
const clang::Expr* made_from(const clang::Expr* expr);

/// Whether the value is a message that an assignment to another one, `target = value`, copies.
bool is_copied_by_assignment(const clang::Expr* target, const clang::Expr* value);

/// Makes a stock message of what is copied there: `= nav_msgs::OccupancyGrid(map_)`. Where a ported message is copied anyway, nothing is lost by
/// it. None: it is written by a macro, or is none of the names and elements that always mean the same message.
std::vector<Change> copied_as_stock(const Unit& unit, const clang::Expr* value);

}  // namespace tzc::rewriter
