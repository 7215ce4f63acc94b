// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"

namespace tzc::monitor {

/// What a look at all processes found.
struct Sample {
  std::vector<Node> nodes;            ///< sorted by name, then by process
  std::vector<std::string> troubles;  ///< pages that could not be read, and why
};

/// Reads the statistics pages of this user's processes (root: of all), through `proc`, the folder /proc. Observed
/// processes do nothing for it and cannot see it.
Sample take_sample(const std::string& proc = "/proc");

}  // namespace tzc::monitor
