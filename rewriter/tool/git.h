// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::rewriter {

/// The top of the work tree that holds a folder; empty: none, or no git here.
std::string git_top(const std::string& folder);

/// Those of the files that git does not have as they are: changed, staged or never added. Ignored files don't
/// count.
std::vector<std::string> uncommitted(const std::string& top, const std::vector<std::string>& files);

}  // namespace tzc::rewriter
