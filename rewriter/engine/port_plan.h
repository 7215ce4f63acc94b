// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

#include "model/edit.h"
#include "model/report.h"

namespace tzc::rewriter {

/// The packages' files that were read -> the main files that include them.
using UnitsOfFile = std::map<std::string, std::set<std::string>>;

/// What is to become of one package.
struct PortPlan {
  Edits edits;            ///< known to compile together
  FileContents contents;  ///< of the edited sources, as they were verified and are to be written
  Report report;
  UnitsOfFile units_of_file;                   ///< of the package
  std::set<std::string> ported_targets_files;  ///< main files whose targets need tzc
  std::set<std::string> needed_headers;        ///< "tzc/ros.h", ...
  std::set<std::string> tzc_types;             ///< "sensor_msgs/Image": twins the ported code uses
  std::set<std::string> joined;  ///< folders of other packages: all of them are written, or none
};

/// By the package's folder.
using PortPlans = std::map<std::string, PortPlan>;

}  // namespace tzc::rewriter
