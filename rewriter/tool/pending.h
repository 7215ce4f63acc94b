// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "report/output.h"

namespace tzc::rewriter {

/// What the port of a package would change, for code scanning: its sites that can be ported and are not. Where only
/// build files would change, the first of them.
std::vector<PendingPlace> pending_places(const PackageReport& package);

/// The folder that code scanning takes paths from: the top of the repository, else the working folder when the package
/// lies below it, else the package.
std::string source_root(const std::string& package_dir);

}  // namespace tzc::rewriter
