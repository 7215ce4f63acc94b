// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "solve/components.h"

namespace tzc::rewriter {

/// The sites that allocate is called for. A message that is ported only because it is copied into the array of another one, which is published
/// (`all.markers.push_back(marker)`), is not among them: the copy has elements of its own, wherever those of the message lie.
std::vector<const AllocationSite*> without_stored(const Facts& facts, const Components& components,
                                                  const Component& component,
                                                  const std::vector<const AllocationSite*>& sites);

}  // namespace tzc::rewriter
