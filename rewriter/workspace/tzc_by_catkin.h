// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>

#include "buildfiles/compile_database.h"
#include "proof/ported_package.h"

namespace tzc::rewriter {

/// Who gets TZC's include folder from a ported package: those that find it, or what depends on it, by catkin, if it exports that it
/// depends on tzc. Their build trees are not configured with the port, so their build files tell.
class TzcByCatkin {
 public:
  explicit TzcByCatkin(const PortedPackage& package);

  /// Whether the package that the command is of does, once it is configured again.
  bool reaches(const CompileCommand& command);

 private:
  bool finds(const std::string& package_dir);
  bool leads_to_ported(const std::string& name);
  std::set<std::string> exported_depends(const std::string& package_dir) const;
  std::string folder_of(const std::string& name);

  const PortedPackage& package_;
  bool exports_ = false;
  std::map<std::string, bool> known_;  ///< packages, by name: whether they lead to the ported one
  std::optional<std::map<std::string, std::string>> folders_;  ///< of the workspace's packages, by name
};

}  // namespace tzc::rewriter
