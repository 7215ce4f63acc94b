// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "paper/tables.h"

namespace tzc {
namespace bench {

// Tables of the paper that tzc-msggen and tzc-rewrite count: their programs lie beside this one, or on the PATH.

/// Counts the message types of some folders together, at any depth: those with a variable-length array, and those of them
/// with a data part, with shares in percent; a row of types_table of this name. Nothing where they cannot be read; `said`
/// gets the reason.
std::optional<Fields> count_types(const std::string& name, const std::vector<std::string>& folders,
                                  std::vector<std::string>& said);

/// Table II: a row a folder of message packages. A type of two folders counts in both.
Table types_table(std::vector<Fields> rows);

/// Counts the files and lines that tzc-rewrite would change in a package, in its diff; nothing is written. Nothing where it
/// cannot be analysed; `said` gets the reason.
std::optional<Fields> count_effort(const std::string& package, std::vector<std::string>& said);

/// One row a package.
Table effort_table(std::vector<Fields> rows);

/// What a unified diff changes.
struct DiffSize {
  std::size_t files = 0, added = 0, removed = 0;
};
DiffSize size_of_diff(const std::string& diff);

/// A row of types_table from what `tzc-msggen classify --json` says.
Fields types_row(const std::string& name, const std::string& classification);

}  // namespace bench
}  // namespace tzc
