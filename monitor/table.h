// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"

namespace tzc::monitor {

/// What is wrong, then the nodes with their topics and connections, for people. Each line ends with a newline.
std::string table(const std::vector<Node>& nodes, bool has_colours);

}  // namespace tzc::monitor
