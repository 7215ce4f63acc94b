// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "model/edit.h"
#include "model/solve_options.h"
#include "solve/components.h"
#include "solve/solution.h"

namespace tzc::rewriter {

/// The edits of a solution, without the includes that they need.
struct PortEdits {
  Edits edits;
  std::map<std::string, std::set<std::string>> headers;  ///< file -> what its new text needs: "tzc/ros.h"
};
PortEdits edits_of(const Facts& facts, const Components& components, const Solution& solution,
                   const SolveOptions& options);

}  // namespace tzc::rewriter
