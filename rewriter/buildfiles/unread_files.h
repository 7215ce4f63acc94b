// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "model/folder_set.h"
#include "model/report.h"

namespace tzc::rewriter {

/// Sources of a package that are not among those that were read (canonical paths).
std::vector<Note> unread_sources(const std::string& package_dir, const FolderSet& generated,
                                 const std::set<std::string>& read);

/// What the package's targets compile besides, and was not read: files that are generated, or lie outside of the package, or have
/// another name than C++ sources have. Of these, those that look as if they held sites.
std::vector<Note> unread_compiled(const std::string& package_dir, const std::string& build_dir,
                                  const FolderSet& generated, const std::set<std::string>& read);

/// Headers of a package that were not read and look as if they held sites.
std::vector<Note> unread_headers(const std::string& package_dir, const FolderSet& generated,
                                 const std::set<std::string>& read);

/// The numbers of lines that look like a site, for a file that was not parsed: "5, 9".
std::string lines_with_sites(const std::string& file);

}  // namespace tzc::rewriter
