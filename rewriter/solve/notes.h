// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "engine.h"
#include "facts/facts.h"
#include "facts/parse.h"

namespace tzc::rewriter {

/// What the user should know beside the sites: sources that are not compiled, branches that were not seen.
std::vector<Note> notes_of(const Facts& facts, const std::vector<CompileUnit>& units,
                           const EngineOptions& options);

}  // namespace tzc::rewriter
