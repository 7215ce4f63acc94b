// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "run/child.h"

namespace tzc::compare {

/// The environment of a shell that has sourced the workspace's setup.bash, less what belongs to a ROS
/// session.
/// @param path the workspace, its devel or install space, or a setup.bash
/// @throws Failure
Environment workspace_environment(const std::string& path);

}  // namespace tzc::compare
