// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "edits/files.h"
#include "other_code/workspace_code.h"
#include "port/port_inputs.h"
#include "report/output.h"

namespace tzc::rewriter {

/// One package, planned: what to write and what to report. Nothing is written yet.
struct PackagePort {
  std::string package_dir;
  FileContents contents;  ///< absolute path -> new content
  Snapshot before;        ///< what was analysed
  PackageReport result;
  std::string build_dir;        ///< holds compile_commands.json, or configured a package without units
  bool has_units = false;       ///< something of it is compiled
  std::set<std::string> units;  ///< main files that must see TZC
  std::map<std::string, std::string>
      made;                      ///< TZC's header of a message of the workspace -> the folder of its package
  HeaderChangeUsers users;       ///< that must see TZC, too, if they really include what is changed
  std::vector<Note> hints;       ///< build file edits that the user must make
  std::set<std::string> joined;  ///< folders of other packages: all of them are written, or none
  bool refused = false;          ///< its build files were not proved: nothing of it is changed
};

/// Analyses packages as one, sources and build files. A package that compiles nothing is ported with those that
/// include its headers, or has nothing to port.
Expected<std::vector<PackagePort>> port_packages(const std::vector<std::string>& package_dirs,
                                                 const PortInputs& inputs);

}  // namespace tzc::rewriter
