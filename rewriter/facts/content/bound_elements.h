// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "facts/syntax/function_view.h"

namespace tzc::rewriter {

/// Whether a mention of a message's own array of messages adds only elements whose arrays get shared memory all the same: `channels.resize(2)`,
/// `channels.push_back(channel)` (tzc::MessageArray, runtime/message/include/tzc/message_array.h). It binds a number of elements that a loop could
/// exceed, so that a loop's push_back is none; nor is what another name of the array adds, whose type may be std::vector.
bool adds_bound_elements(const FunctionView& view, const clang::Expr* array);

}  // namespace tzc::rewriter
