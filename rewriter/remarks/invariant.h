// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "model/expected.h"
#include "model/report.h"

namespace tzc::rewriter {

/// Checks the invariants of every report: each site once, a level that fits its kind, and a code on each site
/// that is not ported. An error is a defect of tzc-rewrite, and nothing is written.
Expected<void> check_report(const Report& report);

}  // namespace tzc::rewriter
