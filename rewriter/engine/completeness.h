// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>

#include "model/api_call.h"
#include "model/expected.h"
#include "model/report.h"

namespace tzc::rewriter {

/// Whether the sites of the report are exactly those calls that lie in its package. An error names the call's file, line
/// and column; it is a defect of tzc-rewrite.
Expected<void> check_complete(const Report& report, const std::set<ApiCall>& calls);

}  // namespace tzc::rewriter
