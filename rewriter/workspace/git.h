// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// The git repository that holds a folder.
struct Repository {
  std::string top;               ///< of its work tree; the folder that holds .git where git does not say
  std::optional<Error> failure;  ///< git does not answer for it: why, and what to do. `where` is `top`
};

/// None: no repository holds the folder. A .git in it or above it is a repository, whatever git says of it.
std::optional<Repository> repository_of(const std::string& folder);

/// The top of the repository that holds a folder; empty: none does.
std::string git_top(const std::string& folder);

/// The folder that code scanning takes paths from: the top of the repository, else the working folder when the package
/// lies below it, else the package.
std::string source_root(const std::string& package_dir);

/// Files whose present content git cannot bring back. Absolute paths.
struct OutsideGit {
  std::set<std::string> uncommitted;  ///< of a repository: changed, staged or never added
  std::set<std::string> unheld;       ///< in no repository, or in one that ignores the file
  std::set<std::string> unwatched;    ///< git was told not to look for changes of it, and tells none
};

/// An error when a repository holds one of the files and git does not answer for it: nothing is known then.
Expected<OutsideGit> outside_git(const std::vector<std::string>& files);

/// The commit that a folder's files come from, with a word when they differ from it; empty: there is none, or git
/// does not say.
std::string commit_of(const std::string& folder);

}  // namespace tzc::rewriter
