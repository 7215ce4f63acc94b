// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model.h"

namespace tzc::monitor {

/// The nodes as one JSON document (docs/tzc-monitor.md).
std::string json_report(const std::vector<Node>& nodes);

}  // namespace tzc::monitor
