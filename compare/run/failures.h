// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

namespace tzc::compare {

/// The nodes that roslaunch's log says have died, with their exit codes: "camera: exit code -11"; of anonymous names without
/// what makes them others in each run. And types of nodes that could not be launched: "camera_pair/camera_node: cannot be
/// launched". Empty without a log.
std::set<std::string> died_nodes(const std::string& roslaunch_log);

/// Describes the end of a command that failed; "" when it ended well.
/// @param status of Child::status
/// @param was_stopped then only crashes count: a signal that was not sent by us
std::string bad_end(const std::string& command, int status, bool was_stopped);

}  // namespace tzc::compare
