// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Ways to write to a message that was given as const, other than a cast of the message.

#include <clang/AST/ExprCXX.h>

#include <optional>
#include <vector>

#include "facts/syntax/unit.h"

namespace tzc::rewriter {

/// A ros::MessageEvent that may give out the very message, though it is to be written to.
struct UncopiedEvent {
  clang::QualType message;            ///< of the event
  const clang::Expr* from = nullptr;  ///< event or pointer that it is made of
};

/// An event that is made with nonconst_need_copy = false, or with a number that is not known. What roscpp gives to callbacks of
/// tzc::subscribe copies, and an event that is made of another one without that argument does what the other one does: so the
/// message itself is given out only where the package says so.
std::optional<UncopiedEvent> uncopied_event(const Unit& unit, const clang::CXXConstructExpr* construct);
/// The same by init(), or by what passes its arguments on: make_shared, emplace_back, forward_as_tuple.
std::optional<UncopiedEvent> uncopied_event(const Unit& unit, const clang::CallExpr* call);

/// The messages that a function may write to because its pointer is cast: those of both types where they differ in their
/// parameters or results; and those that it may write to anyway, where its address becomes a number or another pointer.
std::vector<clang::QualType> messages_of_cast_function(const Unit& unit, const clang::ExplicitCastExpr* cast);

}  // namespace tzc::rewriter
