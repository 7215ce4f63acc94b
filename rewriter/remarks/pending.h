// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "report/output.h"

namespace tzc::rewriter {

/// What the port of a package would change, for code scanning: its sites that can be ported and are not. Where only
/// build files would change, the first of them.
std::vector<PendingPlace> pending_places(const PackageReport& package);

}  // namespace tzc::rewriter
