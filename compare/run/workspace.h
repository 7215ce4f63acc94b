// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "run/child.h"

namespace tzc::compare {

/// The setup.bash of a workspace, of its devel or install space, or the file itself.
/// @throws Failure when there is none
std::string setup_file(const std::string& workspace);

/// The environment of a shell that has sourced the workspace's setup.bash, less what belongs to a ROS
/// session.
/// @param path the workspace, its devel or install space, or a setup.bash
/// @throws Failure
Environment workspace_environment(const std::string& path);

}  // namespace tzc::compare
