// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// package ──parse──> facts ──solve──> components ──rules──> edits ──verify (demote, again)──> PortPlan
//                                                                                               │
//            report (text, JSON, SARIF, HTML) <── tool ──> diff / staged files, swapped in together

#include <set>
#include <string>
#include <vector>

#include "engine/options.h"
#include "model/edit.h"
#include "model/expected.h"
#include "model/report.h"

namespace tzc::rewriter {

struct PortPlan {
  Edits edits;            ///< known to compile together
  FileContents contents;  ///< of the edited sources, as they were verified and are to be written
  Report report;
  std::vector<std::string>
      parsed_files;  ///< all files read of the package: hashed to detect concurrent changes
  std::set<std::string> ported_targets_files;  ///< main files whose targets need tzc
  std::set<std::string> needed_headers;        ///< "tzc/ros.h", ...
  std::set<std::string> tzc_types;             ///< "sensor_msgs/Image": twins the ported code uses
};

/// Parses, solves, edits, verifies, demotes. Writes nothing. An error when a file does not parse, or when the
/// report does not hold every call of the package that advertises, publishes or subscribes.
Expected<PortPlan> plan_port(const EngineOptions& options);

}  // namespace tzc::rewriter
