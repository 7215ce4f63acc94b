// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/edit.h"
#include "model/expected.h"

namespace tzc::rewriter {

struct PackageXml {
  std::string path;
  std::string name;
  int format = 1;
  bool catkin = false;  ///< is its build tool, or format 1 names no build tool
};

Expected<PackageXml> read_package_xml(const std::string& package_dir);

/// Adds <depend>tzc</depend> (format 1: build_depend and run_depend; where one of these, or of their like, is there, the
/// missing ones of build_depend and exec_depend) after the last element of its kind. No edit when the dependency exists.
Expected<Edits> depend_on_tzc(std::string_view content, const std::string& path);

}  // namespace tzc::rewriter
