// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// The commands that follow the port of a package: how to build it again, and before that, where needed, how
/// to make catkin find tzc. Reads the environment and the workspace's folders; one or more whole lines.
std::string next_steps(const std::string& package_dir);

}  // namespace tzc::rewriter
