// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::rewriter {

/// The top of the work tree that holds a folder; empty: none, or no git here.
std::string git_top(const std::string& folder);

/// The files of which git does not have the present content: changed, staged or never added. Ignored files do
/// not count.
std::vector<std::string> uncommitted(const std::string& top, const std::vector<std::string>& files);

/// The commit that a folder's files come from, with a word when they differ from it; empty: there is none.
std::string commit_of(const std::string& folder);

}  // namespace tzc::rewriter
