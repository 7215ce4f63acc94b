// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>

#include <string>
#include <vector>

#include "model.h"

namespace tzc::monitor {

/// A status for each node that has a page, and for each other node that has a problem: OK, or its worst problem, with all of
/// them and its counts as values. Pure.
std::vector<diagnostic_msgs::DiagnosticStatus> statuses(const std::vector<Node>& nodes,
                                                        const std::string& host);

}  // namespace tzc::monitor
