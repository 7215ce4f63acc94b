// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "cache/path_state.h"
#include "port/package_port.h"

namespace tzc::rewriter {

/// What the result for some packages depends on beside what the compilers and CMake are seen to read.
struct CacheInputs {
  std::string settings;           ///< options, environment, what was found where: compared as a text
  std::set<std::string> trees;    ///< whole folders: the packages, and the workspace that CMake configures
  std::set<std::string> omitted;  ///< folders in these that are not sources: build trees
  std::set<FileAccesses::Entry> places;
  bool complete = true;  ///< false: the result must not be kept
};

/// Reads no source. Packages of one build tree.
CacheInputs cache_inputs(const std::vector<std::string>& packages, const PortInputs& inputs);

/// Variables that no compiler or CMake file has a reason to read: of the terminal, the login session, and CI's numbers of
/// runs. All others count.
bool is_session_variable(const std::string& name);

}  // namespace tzc::rewriter
