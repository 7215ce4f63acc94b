// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "measure.h"
#include "options.h"

namespace tzc {
namespace bench {

using Contenders = std::vector<std::unique_ptr<Contender>>;

/// "tcpros, tzc": for messages.
std::string names_of(const Contenders& contenders);

/// The contender of this name; null: there is none.
Contender* find_contender(const Contenders& contenders, const std::string& name);

/// A name of --only that nobody has; empty: there is none.
std::string unknown_name(const Options& options,
                         const std::function<bool(const std::string& name)>& is_known);

/// The wanted contenders with their cases, in the order in which they take turns. Setup::name is empty.
std::vector<std::pair<Contender*, Setup>> wanted_cells(const Options& options, const Contenders& contenders);

/// What to say when there is none.
constexpr char nobody_takes_these_sizes[] =
    "none of the wanted contenders takes messages of these sizes; name others with --only or --sizes";

/// Measures every wanted contender at every size and number of subscribers, the contenders taking turns,
/// prints the table and writes the JSON file. What fails, or delivers nothing, is named and left out. The exit code: 1: one has
/// failed, or the file cannot be written; 2: --only names nobody, or none takes such sizes; 130: interrupted (hold_interrupts), and no file is written.
int sweep(const Options& options, const Contenders& contenders);

}  // namespace bench
}  // namespace tzc
