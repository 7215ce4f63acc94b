// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <clang/AST/Expr.h>

#include <string>

#include "facts/entity_table.h"
#include "model/ids.h"

namespace tzc::rewriter {

/// A member or global message that is published or passed on as a whole.
struct StandingMessage {
  EntityId id;
  const clang::Expr* expr;
  const clang::FunctionDecl* function;  ///< around it
};

/// Where a function mentions a member message of one object, as offsets.
struct MemberMentions {
  unsigned first = ~0U, first_of_arrays = ~0U, last = 0;
  unsigned object_handed_on =
      ~0U;  ///< a function gets the object that the message is part of, and may fill it

  /// With what gets the object as a mention of the arrays.
  MemberMentions with_object() const;
};
MemberMentions mentions_of(const Unit& unit, EntityTable& entities, const StandingMessage& member);

/// What leads to a member: "frame_->", "slots_[i]."; empty for one of this object, and for a global.
std::string way_to(const Unit& unit, const clang::Expr* mention);

/// The local variable or parameter that a member message is part of, and ends with; "": none. What a pointer or a reference to a
/// member, a global or an element leads to lasts: it is allocated already when it is filled again.
std::string object_that_ends(const clang::Expr* mention);
/// Whether that variable is made new, without content.
bool object_is_made_here(const clang::Expr* mention);

}  // namespace tzc::rewriter
