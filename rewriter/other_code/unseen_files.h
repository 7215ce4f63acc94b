// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/folder_set.h"
#include "model/unseen_file.h"
#include "other_code/package_headers.h"

namespace tzc::rewriter {

/// The text files of packages, and which of their files each includes.
class IncludeGraph {
 public:
  explicit IncludeGraph(const FolderSet& packages);

  /// A file that a build compiles, wherever it lies and whatever it is called.
  void add_compiled(const std::string& file);

  const FolderSet& packages() const { return packages_; }
  /// C++ sources, headers, templates of such, and what is compiled.
  const std::set<std::string>& code() const { return code_; }
  /// What a file includes itself.
  const std::set<std::string>& included_by(const std::string& file) const;
  /// What a file includes, through others, too.
  std::set<std::string> reached_from(const std::string& file) const;

 private:
  void add(const std::string& file);

  FolderSet packages_;
  PackageHeaders headers_;
  std::map<std::string, std::set<std::string>> included_;
  std::set<std::string> code_;
};

/// The graphs of a run: reading a workspace takes longer than porting a package of it. A port does not change what
/// the files of packages include of each other.
class IncludeGraphs {
 public:
  const IncludeGraph& of(const std::set<std::string>& packages);

 private:
  std::map<std::set<std::string>, IncludeGraph> graphs_;
};

/// The code that includes a header of the packages and is not among the analysed files.
std::vector<UnseenFile> unseen_files(const IncludeGraph& graph, const FolderSet& packages,
                                     const std::map<std::string, std::set<std::string>>& units_of_file);

}  // namespace tzc::rewriter
