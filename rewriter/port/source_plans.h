// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/port_plan.h"
#include "other_code/workspace_code.h"
#include "port/port_inputs.h"

namespace tzc::rewriter {

/// What is to become of the sources of packages that are solved as one.
struct SourcePlans {
  PortPlans plans;
  std::map<std::string, std::string>
      workspace_messages;                          ///< the workspace's message packages -> their folders
  std::map<std::string, HeaderChangeUsers> users;  ///< by the package that is changed
};

/// With --exported-headers=change their headers may change where every file
/// that includes one belongs to these packages and is compiled.
Expected<SourcePlans> plan_sources(const std::vector<SourcePackage>& packages, const PortInputs& inputs);

}  // namespace tzc::rewriter
