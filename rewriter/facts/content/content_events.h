// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "facts/escape/publish_events.h"
#include "facts/syntax/function_view.h"
#include "model/content_flow.h"

namespace tzc::rewriter {

/// What a function does to the content of messages, in the order of its control flow; none: nothing. Messages of the stock
/// types and their twins alike, so that a port is seen as its original is.
std::optional<ContentFlow> content_flow(EscapeContext& context, const SeenFunction& function);
/// Likewise what a closure of the function does when it is called.
std::optional<ContentFlow> content_flow(EscapeContext& context, const SeenFunction& function,
                                        const clang::LambdaExpr* closure);

}  // namespace tzc::rewriter
