// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "options.h"
#include "paper/cell.h"
#include "paper/page.h"
#include "paper/store.h"

namespace tzc {
namespace bench {

/// Sends so many messages to the cell's subscribers.
using MeasureCell = std::function<Measurement(const Cell& cell, std::size_t count)>;

/// How the measuring ended. Whatever has been measured is in the store.
enum class Progress { complete, with_failures, interrupted };

/// Measures the rounds that the store lacks, the cells taking turns. A measurement that fails is reported and left
/// out; the next run tries it again.
Progress measure_missing(const Options& options, const std::vector<Cell>& cells, const Store& store,
                         const MeasureCell& measure);

/// Writes the tables, results.json, the page and, if wanted, the plots of what the store has; cells of which it has
/// nothing are left out, and files of earlier runs that do not belong to them are removed.
/// `more`: sections that end the page.
void write_reports(const Options& options, const std::vector<Cell>& cells, const Store& store,
                   bool with_plots, const std::vector<Section>& more = {});

}  // namespace bench
}  // namespace tzc
