// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "edits/expected.h"
#include "report/model.h"

namespace tzc::rewriter {

/// What every report promises: each site once, a level that fits its kind, and a code wherever a data-heavy
/// site is not ported. An error is a defect of tzc-rewrite, and nothing is written.
Expected<void> check_report(const Report& report);

}  // namespace tzc::rewriter
