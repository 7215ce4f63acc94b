// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "model/folder_set.h"
#include "tool/include_folders.h"

namespace tzc::rewriter {

/// The files of packages, and which of them an include directive may mean. They are searched as text, so that a branch of the
/// preprocessor that is not compiled counts, too, and a name that may stand for two files counts for both. A file of another
/// package means those that may be found from a folder that it may have among its include folders.
class PackageHeaders {
 public:
  explicit PackageHeaders(const FolderSet& packages);

  /// By any file; of a CMake file, what precompiled headers name.
  std::set<std::string> included_by(const std::string& file);

 private:
  std::set<std::string> meant_by(const std::string& name, bool quoted, const std::string& file);
  bool is_found(const std::string& header, const std::string& name, const std::string& file);

  FolderSet packages_;
  IncludeFolders folders_;
  std::map<std::string, std::set<std::string>> by_name_;  ///< last part of the path -> paths
};

}  // namespace tzc::rewriter
