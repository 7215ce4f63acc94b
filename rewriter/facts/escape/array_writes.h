// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "facts/escape/escape_context.h"
#include "facts/escape/publish_events.h"
#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// What was got through const access may lie in memory that subscribers share: the array leaves it behind when it is
/// written to. These are the writes of a function to arrays and messages that it mentions.
std::vector<SeenEvent> array_writes(EscapeContext& context, const FunctionView& view);
/// Those through a variable that is such an array, or refers or points to one.
std::vector<SeenEvent> writes_through(const FunctionView& view, const clang::VarDecl* array,
                                      const std::vector<EntityId>& messages);

}  // namespace tzc::rewriter
