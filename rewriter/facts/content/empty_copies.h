// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/syntax/function_view.h"
#include "facts/syntax/message_parts.h"

namespace tzc::rewriter {

/// Whether a copy is made only where its original has no elements: `if (in.data.empty()) return in;`. The copy is what the branch runs first, so
/// that nothing fills the original in between, and the array is the only one that the message has.
bool copies_nothing(const FunctionView& view, const MessageParts& parts, const clang::Expr* copy);

}  // namespace tzc::rewriter
