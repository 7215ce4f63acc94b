// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"
#include "problems.h"

namespace tzc::monitor {

/// One line: how much there is, and how many problems of each kind. It tells all where the screen has no room for more.
std::string summary(const std::vector<Node>& nodes, const std::vector<Problem>& found);

}  // namespace tzc::monitor
