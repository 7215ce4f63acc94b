// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "model/folder_set.h"

namespace tzc::rewriter {

/// The files of packages, and which of them an include directive may mean. They are searched as text, so that a branch of the
/// preprocessor that is not compiled counts, too, and a name that may stand for two files counts for both.
class PackageHeaders {
 public:
  explicit PackageHeaders(const FolderSet& packages);

  /// By any file; of a CMake file, what precompiled headers name.
  std::set<std::string> included_by(const std::string& file) const;

 private:
  std::set<std::string> meant_by(const std::string& name, bool quoted, const std::string& file) const;

  std::map<std::string, std::set<std::string>> by_name_;  ///< last part of the path -> paths
};

}  // namespace tzc::rewriter
