// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "facts/escape/publish_events.h"
#include "facts/syntax/function_view.h"
#include "model/content_flow.h"

namespace tzc::rewriter {

/// What a function does to the content of messages, in the order of its control flow; none: nothing. Messages of the stock
/// types and their twins alike, so that a port is seen as its original is.
std::optional<ContentFlow> content_flow(EscapeContext& context, const SeenFunction& function);
/// Likewise what a closure of the function may do when it is called: a generic one does what one of its instances does.
std::vector<ContentFlow> closure_flows(EscapeContext& context, const SeenFunction& function,
                                       const clang::LambdaExpr* closure);

}  // namespace tzc::rewriter
