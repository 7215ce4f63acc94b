// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>

namespace tzc::rewriter {

/// Which folders of a package may be include folders of other packages' code, by what CMake files say. They are read as text,
/// so that variables, conditions and functions need not be understood.
class IncludeFolders {
 public:
  /// Whether a file of another package may be compiled with this folder, of `package` or above it, among its include folders. It
  /// may where the folder is called include, is the package's or lies above; where a CMake file of either package ends a path
  /// with its name, behind its parent's or a variable, or has the parts of such a path; and where nobody can tell: the folders
  /// are gathered by a pattern, there is no CMakeLists.txt, or the file lies in no package. All paths are canonical.
  bool may_serve(const std::string& folder, const std::string& package, const std::string& file);

 private:
  /// What the CMake files of a package say.
  struct Words {
    bool is_known = false;
    bool has_patterns = false;   ///< for folders: "include/lib/*"
    std::set<std::string> last;  ///< parts of paths, and other words: "filters"
    std::set<std::pair<std::string, std::string>>
        pairs;                       ///< the last two parts of paths: "pcl_ros", "filters"
    std::set<std::string> suffixes;  ///< that commands such as find_path() add to paths

    bool may_name(const std::string& parent, const std::string& name) const;
  };
  const Words& words_of(const std::string& package);
  static void add(const std::string& cmake_file, const std::string& project, Words& words);

  std::map<std::string, Words> words_;  ///< by package
};

}  // namespace tzc::rewriter
