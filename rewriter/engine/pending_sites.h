// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model/edit.h"
#include "model/facts.h"
#include "model/site.h"
#include "solve/components.h"

namespace tzc::rewriter {

/// Marks the ported sites that these edits are for. A site whose publisher and messages have TZC's types already
/// has none and stays unmarked.
void mark_pending(std::vector<Site>& sites, const Facts& facts, const Components& components,
                  const Edits& edits);

}  // namespace tzc::rewriter
