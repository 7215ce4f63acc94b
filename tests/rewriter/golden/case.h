// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/engine.h"
#include "support/golden_case.h"
#include "support/temp_dir.h"

// A golden case is one file:
//
//   // What is shown.
//   //RUN: level=one_copy without=allocate         (optional)
//   ... code of src/node.cpp ...
//   //--- include/node.h                           (optional: further files)
//   ...
//   //--- expected
//   // publish src/node.cpp:12 sensor_msgs/Image zero_copy
//   //
//   // -  ros::Publisher pub;
//   // +  tzc::Publisher pub;
//
// The section `expected` is compared as a whole, so any extra site, diagnostic or edit fails.
// TZC_UPDATE_GOLDEN=1 writes what was found into the case.
//
// The case's folder is its outcome, and asserted too: the worst level of its sites (plain, one_copy, copied, zero_copy,
// shared, not_needed, in this order), `no_site`, or `error`.

namespace tzc::rewriter::test {

struct Case {
  tzc::test::GoldenCase golden;
  std::map<std::string, std::string> files;     ///< relative path -> content
  std::map<std::string, std::string> settings;  ///< of the RUN line
};

Case read_case(const std::string& path);

/// A package on disk that holds the case's files; removed in the end.
class Package {
 public:
  /// `flags`: of the compiler.
  explicit Package(const std::map<std::string, std::string>& files, const std::string& flags = "");
  const std::string& dir() const { return dir_.path(); }
  EngineOptions options(const std::map<std::string, std::string>& settings) const;

 private:
  tzc::test::TempDir dir_;
};

Package package_of(const Case& one);

/// Sites, notes and changed lines, as they stand in a case.
std::string describe(const Package& package, const Case& one, const PortPlan& plan);

/// The name of the folder that a case with this result belongs to.
std::string outcome(const Expected<PortPlan>& plan);

/// What each site keeps when the port is applied: id, kind, type, topic, level, code. Sorted.
std::vector<std::string> lasting_sites(const PortPlan& plan);

/// The files with the plan's edits, by relative path.
std::map<std::string, std::string> ported(const Package& package, const Case& one, const PortPlan& plan);

}  // namespace tzc::rewriter::test
