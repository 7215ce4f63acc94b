// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>

#include "model/expected.h"
#include "model/folder_set.h"

namespace tzc::rewriter {

/// Qualified names of functions that keep no pointer which they are given, and why that is so.
using TrustedFunctions = std::map<std::string, std::string>;

/// Reads for each package the nearest `.tzc-rewrite.yaml` in its folder or above it; empty when there is none. The error
/// names the line.
Expected<TrustedFunctions> load_trusted_functions(const FolderSet& packages);

}  // namespace tzc::rewriter
