// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "engine/options.h"
#include "engine/read_unit.h"
#include "model/report.h"

namespace tzc::rewriter {

/// Remarks that belong to no site: files that are not compiled, branches that were not seen.
std::vector<Note> notes_of(const UnitReading& reading, const std::vector<CompileUnit>& units,
                           const EngineOptions& options);

}  // namespace tzc::rewriter
