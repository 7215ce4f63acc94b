// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solve/components.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// One text subscribes for several instances of a template, and one filter for several calls: it is changed for all of them, or for
/// none. Refuses the subscriptions that were to be ported beside one that was refused, and those that would change a text in several ways.
void refuse_together(const Components& components, Solution& solution);

}  // namespace tzc::rewriter
