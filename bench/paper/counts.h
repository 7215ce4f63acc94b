// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/page.h"
#include "paper/paper_options.h"
#include "paper/store.h"

namespace tzc {
namespace bench {

/// The sections of what is counted and not measured: message types and changed lines. Counts the folders that the options
/// name and keeps their rows in the store, in counts.json; the tables have these rows and those of earlier runs. Message
/// types have a last row for all folders together, where there are several; a type of two folders counts in it once. What
/// cannot be counted keeps the row that it has, and `said` gets the reason.
std::vector<Section> counted_sections(const Store& store, const PaperOptions& options,
                                      std::vector<std::string>& said);

}  // namespace bench
}  // namespace tzc
