// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/folder_set.h"
#include "model/unseen_file.h"

namespace tzc::rewriter {

/// The text files of source spaces, and which of their files each includes.
class IncludeGraph {
 public:
  /// `others`: files that lie elsewhere, as those that a build generates.
  IncludeGraph(const FolderSet& spaces, const std::set<std::string>& others);

  /// C++ sources, headers, and templates of such.
  const std::set<std::string>& code() const { return code_; }
  /// What a file includes, through others, too.
  std::set<std::string> reached_from(const std::string& file) const;

 private:
  std::map<std::string, std::set<std::string>> included_;
  std::set<std::string> code_;
};

/// The code that includes a header of the packages and is not among the analysed files.
std::vector<UnseenFile> unseen_files(const IncludeGraph& graph, const FolderSet& packages,
                                     const std::map<std::string, std::set<std::string>>& units_of_file);

}  // namespace tzc::rewriter
