// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "model.h"

namespace tzc::monitor {

/// Fills in the rates of nodes that an earlier sample has, too. They are exact: each page says when it was updated. A page
/// that was not updated in between keeps its earlier rates, or has rates of 0 when its process is stopped or silent.
void add_rates(const std::vector<Node>& before, std::vector<Node>& now);

}  // namespace tzc::monitor
