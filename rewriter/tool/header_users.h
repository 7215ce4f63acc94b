// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/report.h"

namespace tzc::rewriter {

/// Headers of a package that other code includes, directly or through other files of the package, each with the
/// file that does so: absolute paths. Includes are searched as text in all C++ files below `roots`, what lies in the
/// package excepted, so a branch of the preprocessor that is not compiled counts, too. A name that two headers
/// of the package may stand for counts for both.
std::map<std::string, std::string> headers_in_use(const std::string& package_dir,
                                                  const std::vector<std::string>& roots);

/// Tells the reader of a report what was searched, and which headers stay.
Note note_on_users(const std::string& package_dir, const std::map<std::string, std::string>& users);

/// Where code lies that may include a package's headers: the workspace, the packages of the command line, the
/// workspaces below this one, and the headers of installed packages that depend on the package.
/// `shares`: folders of installed packages' files, such as /usr/share.
std::vector<std::string> roots_of_users(const std::string& package, const std::string& workspace,
                                        const std::vector<std::string>& named,
                                        const std::vector<std::string>& shares);

}  // namespace tzc::rewriter
