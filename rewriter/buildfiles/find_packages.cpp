// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/find_packages.h"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <set>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

bool is_skipped(const fs::path& folder) {
  return folder.filename().string().front() == '.' || is_there(folder / "CATKIN_IGNORE");
}

/// Catkin follows symbolic links, too: to a package, or to a repository with packages.
class PackageSearch {
 public:
  explicit PackageSearch(const fs::path& root) : root_(root) {}

  std::vector<std::string> run() {
    search(root_, std::numeric_limits<unsigned>::max());
    const std::vector<fs::path> links = std::move(links_);  // not those that are found behind these
    for (const fs::path& link : links) search_behind(link);
    return std::move(packages_);
  }

 private:
  void search(const fs::path& folder, unsigned depth) {
    if (!seen_.insert(folder).second) return;
    std::error_code ignored;
    if (fs::exists(folder / "package.xml", ignored)) return packages_.push_back(folder);
    if (depth == 0) return;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
      if (!entry.is_directory(ignored) || is_skipped(entry.path())) continue;
      if (entry.is_symlink(ignored))
        links_.push_back(entry.path());
      else
        search(entry.path(), depth - 1);
    }
  }

  /// Deep enough for a repository, and not for a disk. What holds the root itself was searched as far as it was asked for.
  void search_behind(const fs::path& link) {
    constexpr unsigned deepest = 3;
    std::error_code failed;
    const fs::path folder = fs::canonical(link, failed);
    if (!failed && !is_below(root_, folder)) search(folder, deepest);
  }

  const fs::path root_;
  std::set<fs::path> seen_;
  std::vector<fs::path> links_;
  std::vector<std::string> packages_;
};

}  // namespace

Expected<std::vector<std::string>> find_packages_at(const std::string& argument) {
  std::error_code failed;
  const fs::path folder = fs::canonical(argument, failed);
  if (failed || !fs::is_directory(folder, failed))
    return Error{"is no folder", argument, "name the folder of a catkin package"};
  std::vector<std::string> packages = PackageSearch(folder).run();
  if (packages.empty())
    return Error{"no package.xml here or below", argument, "name the folder of a catkin package"};
  std::sort(packages.begin(), packages.end());
  return packages;
}

}  // namespace tzc::rewriter
