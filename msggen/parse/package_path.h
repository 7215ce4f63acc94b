// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tzc::msggen {

/// Where the definitions of a package lie: package name to folders of .msg files.
using SearchPath = std::map<std::string, std::vector<std::string>>;

/// A package's folder, and those inside it that hold definitions.
struct Package {
  std::string name;
  std::string directory;
  /// It, or one of its name that it hides, lies in PREFIX/share, its C++ headers therefore in PREFIX/include.
  bool installed = false;

  std::string message_directory() const { return directory + "/msg"; }
  /// That folder and those below it: add_message_files(DIRECTORY msg/sub) puts messages there. Their names do not tell.
  std::vector<std::string> message_directories() const;
  /// All .msg, .srv and .action files, sorted, without an action's messages that are also installed as .msg.
  std::vector<std::string> definition_files() const;
};

/// The packages under some folders. A package is a folder with a package.xml, or one with a msg/, srv/ or
/// action/ folder inside; packages inside packages do not count. Of two packages with one
/// name, the first found counts.
class PackageIndex {
 public:
  /// Looks into each folder. A folder called `share` is an install space: packages lie directly in it.
  explicit PackageIndex(const std::vector<std::string>& folders);

  const Package* find(const std::string& name) const;
  const std::map<std::string, Package>& all() const { return packages_; }

 private:
  void add_install_space(const std::string& share);
  void add_tree(const std::string& folder, int depth);
  bool add_package(const std::string& folder, bool installed);

  std::map<std::string, Package> packages_;
};

/// The package that lies in this folder, if it is one.
std::optional<Package> package_in(const std::string& folder);

/// ROS's package path: ROS_PACKAGE_PATH, then share/ of each entry of CMAKE_PREFIX_PATH, then the ROS
/// installation that this program was built with.
std::vector<std::string> ros_package_path();

}  // namespace tzc::msggen
