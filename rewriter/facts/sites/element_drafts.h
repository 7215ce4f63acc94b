// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "facts/sites/allocation_sites.h"

namespace tzc::rewriter {

/// The site of a variable that is declared, as one of each of those elements. A statement for each, behind the declaration: what lies in
/// the array is as new there as a single message is.
std::vector<AllocationDraft> of_each_element(const std::optional<AllocationDraft>& declared);

}  // namespace tzc::rewriter
