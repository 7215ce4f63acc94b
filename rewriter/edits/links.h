// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

namespace tzc::rewriter {

/// The symbolic links below a folder, to files and to folders, each with what it leads to, canonical. Links are not followed,
/// and hidden folders not searched.
std::map<std::string, std::string> links_below(const std::string& folder);

/// A folder and what links in it lead to, as far as it lies in the package: all whose files are found by way of the folder.
/// Canonical.
std::set<std::string> with_links(const std::string& folder, const std::string& package_dir);

}  // namespace tzc::rewriter
