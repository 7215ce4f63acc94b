// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/folder_set.h"
#include "model/report.h"

namespace tzc::rewriter {

/// A file that includes a header of another package: absolute paths.
struct Inclusion {
  std::string file, header;
};

/// Includes between packages. They are searched as text in all C++ files, so a branch of the preprocessor that is not
/// compiled counts, too, and a name that may stand for two headers counts for both.
std::vector<Inclusion> inclusions_between(const std::vector<std::string>& packages);

/// The files of the packages that a compiler may read of these ones, by their includes. Searched as text: what is not among them
/// is in no unit, unless a macro names it.
std::set<std::string> reached_by_includes(const std::vector<std::string>& packages,
                                          const std::set<std::string>& compiled);

/// The packages, those together of which one includes a header of another; in the order given.
std::vector<std::vector<std::string>> joined_by_headers(const std::vector<std::string>& packages);

/// Where other code is searched: below `roots`, without `left_out`. Folders, canonical if they are left out.
struct SearchedFolders {
  std::vector<std::string> roots, left_out;
};

/// Headers of the packages that other code includes, directly or through other files of the packages, each with the
/// file that does so: absolute paths. Searched as text in all C++ files of `searched`, what lies in the packages
/// excepted. `known`: inclusions that count though they lie in the packages.
std::map<std::string, std::string> headers_in_use(const FolderSet& packages, const SearchedFolders& searched,
                                                  const std::vector<Inclusion>& known = {});

/// Tells the reader of a package's report what was searched, and which headers stay. `others`: names of the packages that
/// were solved as one with it.
Note note_on_users(const std::string& package_dir, const std::map<std::string, std::string>& users,
                   const std::vector<std::string>& others = {});

/// Says with --exported-headers=keep how many sites would be looked at again with `change`. None: no site waits for that.
std::optional<Note> note_on_kept_headers(const Report& report);

/// Where code lies that may include a header of one of these packages (names): the workspace, what the command line names, the
/// workspaces below this one, and the headers of installed packages that depend on one of them. Left out are packages of
/// the latter two of which the command line names other sources, which hide them, and TZC.
/// `shares`: folders of installed packages' files, such as /usr/share.
SearchedFolders folders_of_users(const std::set<std::string>& packages, const std::string& workspace,
                                 const std::vector<std::string>& named, const std::set<std::string>& shares);

}  // namespace tzc::rewriter
