// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/tables.h"

namespace tzc {
namespace bench {

// Tables of the paper that tzc-msggen and tzc-rewrite count: their programs lie beside this one, or on the PATH.

/// Table II: one row a folder of message packages, at any depth, and a last one for all of them, when there are several:
/// types, those with a variable-length array, and those of them with a data part, with shares in percent. A type of two
/// folders counts in both, and once in the last row. A folder that cannot be read has no row; `said` gets the reason.
Table types_table(const std::vector<std::string>& folders, std::vector<std::string>& said);

/// One row a package: files and lines that tzc-rewrite would change, which is counted in its diff; nothing is written. A
/// package that cannot be analysed has no row; `said` gets the reason.
Table effort_table(const std::vector<std::string>& packages, std::vector<std::string>& said);

/// What a unified diff changes.
struct DiffSize {
  std::size_t files = 0, added = 0, removed = 0;
};
DiffSize size_of_diff(const std::string& diff);

/// A row of types_table from what `tzc-msggen classify --json` says.
std::vector<std::string> types_row(const std::string& name, const std::string& classification);

}  // namespace bench
}  // namespace tzc
