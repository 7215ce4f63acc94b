// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "measure.h"
#include "options.h"

namespace tzc {
namespace bench {

/// Measures every wanted contender at every size and number of subscribers, contenders alternating, prints the table
/// and writes the JSON file; the exit code.
int sweep(const Options& options, const std::vector<std::unique_ptr<Contender>>& contenders);

}  // namespace bench
}  // namespace tzc
