// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/folder_set.h"
#include "model/report.h"

namespace tzc::rewriter {

/// What is wrong with a --only or --except value; empty: nothing.
std::string filter_format(const std::string& text);

/// `only` and `except` hold "topic=GLOB", "type=GLOB", "file=GLOB" (relative to the package). Of --only each
/// kind that is given must match with one of its globs; of --except none may match. A leading '/' of topics
/// does not matter. Empty when everything is wanted.
SiteFilter make_filter(const std::vector<std::string>& only, const std::vector<std::string>& except,
                       const FolderSet& packages);

/// Whether one of the globs, relative to the package, names the file.
bool is_file_of(const std::string& file, const std::vector<std::string>& globs, const FolderSet& packages);

}  // namespace tzc::rewriter
