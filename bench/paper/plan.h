// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "options.h"
#include "paper/cell.h"
#include "paper/tables.h"

namespace tzc {
namespace bench {

/// The most memory that a cell's processes need together.
using MemoryOf = std::function<std::size_t(const Cell& cell)>;

/// What a run would measure, as text: a row for each contender and kind of conditions, and one for all of them.
/// `results`: what has been measured already.
std::string plan_text(const Options& options, const std::vector<CellResult>& results,
                      const MemoryOf& memory_of);

}  // namespace bench
}  // namespace tzc
