// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "engine/port_plan.h"
#include "tool/port_inputs.h"

namespace tzc::rewriter {

struct SourcePackage {
  std::string dir, name;
  std::string build_dir;
  bool has_units = true;  ///< `build_dir` holds their compile_commands.json; false: it compiles nothing
};

/// What is to become of the sources of packages that are solved as one.
struct SourcePlans {
  PortPlans plans;
  std::map<std::string, std::string>
      workspace_messages;  ///< the workspace's message packages -> their folders
  std::map<std::string, std::set<std::string>>
      users;  ///< package -> compiled sources, also other packages', that seem to include what is changed of it
  std::map<std::string, std::vector<CompileCommand>> other_users;  ///< likewise, in build trees of their own
};

/// With --exported-headers=change their headers may change where every file
/// that includes one belongs to these packages and is compiled.
Expected<SourcePlans> plan_sources(const std::vector<SourcePackage>& packages, const PortInputs& inputs);

}  // namespace tzc::rewriter
