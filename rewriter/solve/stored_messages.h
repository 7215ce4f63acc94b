// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solve/components.h"
#include "solve/site_index.h"

namespace tzc::rewriter {

/// The allocation sites of a component that allocate is called for. A message that is ported only because it is copied into the array of another one, which is published
/// (`all.markers.push_back(marker)`), is not among them: the copy has elements of its own, wherever those of the message lie.
SiteIndex::Sites<AllocationSite> without_stored(const Facts& facts, const SiteIndex& sites,
                                                const Component& component);

}  // namespace tzc::rewriter
