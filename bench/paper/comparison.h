// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "paper/cell.h"
#include "paper/tables.h"

namespace tzc {
namespace bench {

/// A row for each contender, over all its cells: the paper's claims, of whoever meets them.
Table overview_table(const std::vector<Summary>& summaries);

/// A row for each size and number of subscribers: the contenders by their medians, the fastest first. "*": see in_full.
Table ranking_table(const std::vector<Summary>& summaries);

}  // namespace bench
}  // namespace tzc
