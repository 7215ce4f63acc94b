// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "report/output.h"

namespace tzc::rewriter {

/// The section of one package: summary, estimate, sites with their flow, notes, side-by-side diff.
std::string html_package(const PackageReport& package);

}  // namespace tzc::rewriter
