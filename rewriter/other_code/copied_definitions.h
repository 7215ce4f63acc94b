// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/copied_definition.h"
#include "model/folder_set.h"

namespace tzc::rewriter {

/// Definitions in headers of the packages that other packages below `root` hold word for word, comments and white space aside,
/// in a header of the same name. Another checkout of one of the packages is none of them.
std::vector<CopiedDefinition> copied_definitions(const FolderSet& packages, const std::string& root);

}  // namespace tzc::rewriter
