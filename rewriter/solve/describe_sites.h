// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/solve_options.h"
#include "solve/components.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// Every site of the package, each exactly once, by place, with the level that the solution gives it.
std::vector<Site> describe_sites(const Facts& facts, const Components& components,
                                 const SolveOptions& options, const Solution& solution);

}  // namespace tzc::rewriter
