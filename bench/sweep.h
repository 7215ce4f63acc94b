// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "measure.h"
#include "options.h"

namespace tzc {
namespace bench {

using Contenders = std::vector<std::unique_ptr<Contender>>;

/// The wanted contenders with their cases, in the order in which they take turns. Setup::name is empty.
std::vector<std::pair<Contender*, Setup>> wanted_cells(const Options& options, const Contenders& contenders);

/// Measures every wanted contender at every size and number of subscribers, the contenders taking turns,
/// prints the table and writes the JSON file; the exit code.
int sweep(const Options& options, const Contenders& contenders);

}  // namespace bench
}  // namespace tzc
