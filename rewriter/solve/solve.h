// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/facts.h"
#include "model/solve_options.h"
#include "solve/components.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// Decides each component once. The solution points into the facts.
Solution solve(const Facts& facts, const Components& components, const SolveOptions& options,
               const Demotions& demotions);

}  // namespace tzc::rewriter
