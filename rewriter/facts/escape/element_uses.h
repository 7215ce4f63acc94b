// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "facts/escape/escape_context.h"
#include "facts/escape/publish_events.h"
#include "model/facts.h"

namespace tzc::rewriter {

/// What a function does with the elements of messages, as far as threads are concerned that use them at the same time. Where it is not
/// seen that it writes, it reads.
std::vector<ElementUse> element_uses(const EscapeContext& context, const SeenFunction& seen);

}  // namespace tzc::rewriter
