// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <set>
#include <string>

#include "edits/expected.h"
#include "report/model.h"

namespace tzc::rewriter {

/// A call that advertises, publishes or subscribes, found by looking for nothing else.
struct ApiCall {
  SiteKind kind = SiteKind::publish;
  Location where;
  std::string type;  ///< "sensor_msgs/Image"; empty: not to be seen at the call
};

bool operator<(const ApiCall& a, const ApiCall& b);

/// Whether the sites of the report are the calls of the package: none is missing, none was made up. An error
/// names the call's file, line and column; it is a defect of tzc-rewrite.
Expected<void> check_complete(const Report& report, const std::set<ApiCall>& calls);

}  // namespace tzc::rewriter
