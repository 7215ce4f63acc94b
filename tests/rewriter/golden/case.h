// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine.h"

// A golden case is one file:
//
//   // What is shown.
//   //RUN: level=one_copy without=allocate         (optional)
//   ... code of src/node.cpp ...
//   //--- include/node.h                           (optional: further files)
//   ...
//   //===
//   // publish src/node.cpp:12 sensor_msgs/Image zero_copy
//   //
//   // -  ros::Publisher pub;
//   // +  tzc::Publisher pub;
//
// Everything behind //=== is compared as a whole, so any extra site, diagnostic or edit fails.
// TZC_UPDATE_GOLDEN=1 writes what was found into the case.

namespace tzc::rewriter::test {

struct Case {
  std::string path;
  std::map<std::string, std::string> files;     ///< relative path -> content
  std::map<std::string, std::string> settings;  ///< of the RUN line
  std::string input;                            ///< the case up to //===
  std::string expected;                         ///< behind it
};

Case read_case(const std::string& path);
void write_expected(const Case& one, const std::string& found);

/// A package on disk that holds the case's files; removed in the end.
class Package {
 public:
  explicit Package(const std::map<std::string, std::string>& files);
  ~Package();
  const std::string& dir() const { return dir_; }
  EngineOptions options(const std::map<std::string, std::string>& settings) const;
  std::string read(const std::string& file) const;

 private:
  std::string dir_;
};

/// Sites, notes and changed lines, as they stand in a case.
std::string describe(const Package& package, const Case& one, const PortPlan& plan);

/// What each site keeps when the port is applied: id, kind, type, topic, level, code. Sorted.
std::vector<std::string> lasting_sites(const PortPlan& plan);

/// The files with the plan's edits, by relative path.
std::map<std::string, std::string> ported(const Package& package, const Case& one, const PortPlan& plan);

}  // namespace tzc::rewriter::test
