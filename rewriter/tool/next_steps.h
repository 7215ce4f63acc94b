// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::rewriter {

struct BuiltPackage {
  std::string dir;
  std::string build_dir;  ///< empty: unknown
};

/// The commands that follow the port of packages (at least one): how to build them again, and before that, where needed,
/// how to make catkin find tzc. Reads the environment and what lies in the build folders and around them; whole lines.
std::string next_steps(const std::vector<BuiltPackage>& packages);

}  // namespace tzc::rewriter
