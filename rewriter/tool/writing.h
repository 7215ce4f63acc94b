// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool/package_port.h"

namespace tzc::rewriter {

/// The diff of all packages. Its paths suit `git apply` from anywhere in the repository that holds both the
/// package and the working folder; otherwise `git apply` and `patch -p1` in the working folder, or in the
/// package's folder when that does not lie below the working folder.
std::string diff_of(const std::vector<PackagePort>& ports);

/// Refuses when git does not have the files as they are.
Expected<void> check_committed(const std::vector<PackagePort>& ports);

/// Changes each package in place, all of its files or none.
Expected<void> write_in_place(const std::vector<PackagePort>& ports);

/// A whole copy of each package, ported, as DIR/<folder of the package>.
Expected<void> write_copies(const std::vector<PackagePort>& ports, const std::string& out_dir);

}  // namespace tzc::rewriter
