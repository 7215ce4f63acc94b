// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "model/edit.h"
#include "model/expected.h"
#include "model/file_accesses.h"
#include "proof/configuration.h"

namespace tzc::rewriter {

/// A package as the port would leave it.
struct PortedPackage {
  std::string name;
  std::string package_dir;           ///< canonical
  FileContents contents;             ///< sources and build files
  std::set<std::string> units;       ///< main files that must see TZC, canonical
  std::set<std::string> users = {};  ///< main files that must, too, if they include one of `contents`
  std::set<std::string> made = {};   ///< TZC's headers that the build has to make: "tzc/demo_msgs/Cloud.h"
};

struct ProofOptions {
  std::vector<std::string> prefixes;  ///< where TZC's CMake package is found when the user's paths have none
  bool build = false;                 ///< build the scratch copy as a whole, too
  FileAccesses* accesses = nullptr;   ///< told what CMake reads; may be null
  unsigned jobs = 0;
  std::function<void(const std::string& stage)> progress;  ///< may be empty
};

/// Why other packages, which have build trees of their own, could not be compiled any more; none: they can. `users`: commands that
/// seem to include what is changed.
std::optional<Error> outdated_user(const PortedPackage& package, const std::vector<CompileCommand>& users);

/// The reasons why packages cannot be written, by folder. A package is proved when the scratch workspace can
/// be configured with it, and when every command that compiles one of its units then finds TZC's headers, those that the build makes
/// included, asks for C++14 or later, and ends in a link with TZC's libraries. All packages belong to one build tree.
std::map<std::string, Error> unproved_packages(const UserBuild& user,
                                               const std::vector<PortedPackage>& packages,
                                               const ProofOptions& options);

}  // namespace tzc::rewriter
