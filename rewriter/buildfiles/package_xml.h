// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "edits/edit.h"

namespace tzc::rewriter {

struct PackageXml {
  std::string path;
  std::string name;
  int format = 1;
  bool catkin = false;  ///< its build tool, or nothing is said and it is format 1
};

Expected<PackageXml> read_package_xml(const std::string& package_dir);

/// <depend>tzc</depend> (format 1: build_depend and run_depend), behind the last of its kind; nothing where
/// the dependency stands already.
Expected<Edits> depend_on_tzc(std::string_view content, const std::string& path);

}  // namespace tzc::rewriter
