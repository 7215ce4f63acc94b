// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/file_accesses.h"

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

}  // namespace tzc::rewriter
