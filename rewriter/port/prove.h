// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "port/package_port.h"

namespace tzc::rewriter {

/// Lets CMake judge the edited build files, with one scratch copy for all packages of a build tree. A package
/// that CMake does not accept keeps all of its files, and its sites are reported as plain with the reason
/// (TZC4005). With --verify=source it configures nothing, and the report says so (TZC4006).
Expected<void> prove_build_files(std::vector<PackagePort>& ports, const PortInputs& inputs);

/// Names the build tree that a package belongs to; the package itself where none is found.
std::string build_tree_of(const std::string& package_dir, const PortOptions& options);

}  // namespace tzc::rewriter
