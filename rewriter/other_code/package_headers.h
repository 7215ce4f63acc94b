// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "model/folder_set.h"
#include "other_code/include_folders.h"

namespace tzc::rewriter {

/// The files of packages, and which of them an include directive may mean, by symbolic links, too. They are searched as text, so that a branch of the
/// preprocessor that is not compiled counts, too, and a name that may stand for two files counts for both. A file of another
/// package means those that may be found from a folder that it may have among its include folders.
class PackageHeaders {
 public:
  explicit PackageHeaders(const FolderSet& packages);

  /// By any file; of a CMake file, what precompiled headers name.
  std::set<std::string> included_by(const std::string& file);

 private:
  void add_files();
  void add_links();
  std::set<std::string> meant_by(const std::string& name, bool quoted, const std::string& file);
  bool is_found(const std::string& header, const std::string& name, const std::string& file);

  FolderSet packages_;
  IncludeFolders folders_;
  std::map<std::string, std::string> links_;  ///< in the packages, to files and folders of them
  /// Last part of the path -> paths, each with the file itself, which another path may lead to.
  std::map<std::string, std::map<std::string, std::string>> by_name_;
};

}  // namespace tzc::rewriter
