// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "model/report.h"

namespace tzc::rewriter {

/// Marks the sites whose remark a comment suppresses: `// tzc-ignore[TZC1004]: reason`, several codes with
/// commas, on the site's line or in the comment lines right above it. Where that line has no such site, the comment holds for the
/// statement that ends, or begins, there: a port may break it into lines. Comments without a reason, with unknown
/// codes or without effect become notes. Looks at the report's files and `more_files`.
void apply_suppressions(Report& report, const std::set<std::string>& more_files);

}  // namespace tzc::rewriter
