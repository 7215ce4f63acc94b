// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/cell.h"
#include "paper/paper_options.h"
#include "sweep.h"

namespace tzc {
namespace bench {

/// Who takes part in which cases.
struct Contestants {
  Contenders usual;
  Contenders real_time;

  /// Null: there is none of this name.
  Contender* find(const std::string& name) const;
};

/// The cases that the options ask for, in the order in which they take turns.
std::vector<Cell> cells_of(const PaperOptions& options, const Contestants& contestants);

/// What the options ask for and no case can be, and what to give instead; empty: nothing. `cells`: cells_of's.
std::string impossible_wish(const PaperOptions& options, const Contestants& contestants,
                            const std::vector<Cell>& cells);

/// Puts cells of whichever runs into the order of cells_of: by conditions, size, subscribers, and as the contenders stand in
/// the tables.
void sort(std::vector<Cell>& cells, const Contestants& contestants);

/// What contender and processes of a cell are told, without a number of messages and a name.
Setup setup_of(const Cell& cell, const PaperOptions& options);

/// The most memory that the cell's processes need together.
std::size_t memory_of(const Cell& cell, const PaperOptions& options, const Contestants& contestants);

/// Why the machine, as it is now, cannot hold the cell's messages; empty: it can.
std::string memory_obstacle(const Cell& cell, const PaperOptions& options, const Contestants& contestants);

/// Takes away the cells that could need more memory than the machine has free, or real time where that is not permitted;
/// `said` gets a line for each reason.
void leave_out_impossible(const PaperOptions& options, const Contestants& contestants,
                          std::vector<Cell>& cells, std::vector<std::string>& said);

}  // namespace bench
}  // namespace tzc
