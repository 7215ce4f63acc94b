// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parse/package.h"

namespace tzc::msggen {

/// Where the definitions of a package lie: package name to folders of .msg files.
using SearchPath = std::map<std::string, std::vector<std::string>>;

/// The packages under some folders. A package is a folder with a package.xml, or one with a msg/, srv/ or
/// action/ folder or one that genmsg's CMake file names; packages inside packages do not count. Of two packages
/// with one name, the first found counts.
class PackageIndex {
 public:
  /// Looks into each folder. A folder called `share` is an install space: packages lie directly in it.
  explicit PackageIndex(const std::vector<std::string>& folders);

  const Package* find(const std::string& name) const;
  const std::map<std::string, Package>& all() const { return packages_; }

 private:
  void add_install_space(const std::string& share);
  void add_tree(const std::string& root);
  bool add_package(const std::string& folder, bool installed);

  std::map<std::string, Package> packages_;
};

/// The package that lies in this folder, if it is one.
std::optional<Package> package_in(const std::string& folder);

/// ROS's package path: ROS_PACKAGE_PATH, then share/ of each entry of CMAKE_PREFIX_PATH, then the ROS
/// installation that this program was built with.
std::vector<std::string> ros_package_path();

}  // namespace tzc::msggen
