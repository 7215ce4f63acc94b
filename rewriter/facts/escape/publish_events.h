// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <vector>

#include "facts/escape/escape_context.h"
#include "facts/syntax/calls.h"
#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// An event in a function's body.
struct SeenEvent {
  PublishEvent event;
  const clang::Stmt* at;            ///< the call, or the declaration whose object is destroyed
  FunctionView::Span span;          ///< when it happens
  const clang::LambdaExpr* lambda;  ///< in whose body
};

/// A function, and the events in its body.
struct SeenFunction {
  const FunctionView& view;
  const std::vector<SeenEvent>& events;
};

/// All that may publish a message in a function's body: publish calls, calls of functions of the package, and
/// calls of code that is not seen, destructors of locals included.
std::vector<SeenEvent> publish_events(EscapeContext& context, const FunctionView& view);

/// The messages that an expression may denote: where its value comes from, and all that it mentions, because a
/// function of a library may return any of its arguments.
std::set<EntityId> messages_of(EscapeContext& context, const clang::Expr* expr);

}  // namespace tzc::rewriter
