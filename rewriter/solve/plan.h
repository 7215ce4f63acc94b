// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include "solve/solution.h"

namespace tzc::rewriter {

/// Reads a file; none: it can not be read.
using ReadFile = std::function<std::optional<std::string>(const std::string& path)>;

/// The edits of a solution, with the includes they need.
struct EditPlan {
  Edits edits;
  std::set<std::string> headers;  ///< all that are included: "tzc/ros.h"
};
EditPlan edits_of(const Facts& facts, const Components& components, const Solution& solution,
                  const EngineOptions& options, const ReadFile& read);

/// The number of the subscribe site's own component: they follow the flow graph's.
int subscribe_component(const Facts& facts, const Components& components, const std::string& id);

/// The edit that includes a header in a file; none: it is included already.
std::optional<Edit> include_edit(const std::string& file, const std::string& content,
                                 const std::string& header);

}  // namespace tzc::rewriter
