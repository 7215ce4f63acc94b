// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>

namespace tzc::rewriter {

/// Which folders of a package may be include folders of other packages' code, by what CMake files say. They are read as text,
/// so that variables, conditions and functions need not be understood.
class IncludeFolders {
 public:
  /// Whether a file of another package may be compiled with this folder, of `package` or above it, among its include folders. It
  /// may where the folder is called include, is the package's or lies above; where a CMake file of either package ends a path
  /// with its name; and where nobody can tell: the folders are gathered by a pattern, there is no CMakeLists.txt, or the file
  /// lies in no package. All paths are canonical.
  bool may_serve(const std::string& folder, const std::string& package, const std::string& file);

 private:
  /// How a package's CMake files end paths.
  struct PathEnds {
    bool is_known = false;
    std::set<std::string> names;  ///< "filters"
    std::set<std::string> pairs;  ///< "pcl_ros/filters"
  };
  const PathEnds& ends_in(const std::string& package);
  static void add(const std::string& cmake_file, const std::string& project, PathEnds& ends);

  std::map<std::string, PathEnds> ends_;  ///< by package
};

}  // namespace tzc::rewriter
