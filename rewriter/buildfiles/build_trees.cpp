// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/build_trees.h"

#include <filesystem>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Of CMAKE_AUTOMOC and its like; others may have folders of such a name, too.
bool is_autogen(const fs::path& folder) {
  const std::string name = folder.filename();
  return ends_with(name, "_autogen") && is_there(folder.parent_path() / "CMakeFiles" / (name + ".dir"));
}

/// A build folder, unless it is the source folder as well.
bool is_build_folder(const fs::path& folder) {
  return is_there(folder / "CMakeCache.txt") && !is_there(folder / "CMakeLists.txt");
}

/// catkin marks its devel and install spaces.
bool is_made(const fs::path& folder) {
  const std::string name = folder.filename();
  return name == "CMakeFiles" || name == "catkin_generated" || is_there(folder / ".catkin") ||
         is_autogen(folder) || is_build_folder(folder);
}

/// The folders in a package that CMake and catkin make.
std::vector<std::string> made_folders(const std::string& package_dir) {
  std::vector<std::string> made;
  std::error_code failed, ignored;
  const auto options = fs::directory_options::skip_permission_denied;
  for (fs::recursive_directory_iterator at(package_dir, options, failed), end; !failed && at != end;
       at.increment(failed)) {
    if (at->is_symlink(ignored) || !at->is_directory(ignored)) continue;
    const bool is_hidden = at->path().filename().string().front() == '.';
    if (!is_hidden && is_made(at->path())) made.push_back(at->path());
    if (is_hidden || is_made(at->path())) at.disable_recursion_pending();
  }
  return made;
}

}  // namespace

bool builds_in_source(const std::string& build_dir, const std::string& package_dir) {
  const std::string build = canonical_path(build_dir), package = canonical_path(package_dir);
  return package == build || is_below(package, build);
}

FolderSet generated_folders(const std::string& build_dir, const std::string& package_dir) {
  std::vector<std::string> folders = made_folders(package_dir);
  if (!build_dir.empty() && !builds_in_source(build_dir, package_dir)) folders.push_back(build_dir);
  return FolderSet(std::move(folders));
}

std::vector<std::string> build_paths(const std::string& build_dir,
                                     const std::vector<std::string>& package_dirs) {
  std::vector<std::string> paths;
  bool in_source = false;
  for (const std::string& package : package_dirs) {
    if (!builds_in_source(build_dir, package)) continue;
    in_source = true;
    for (std::string& folder : made_folders(package)) paths.push_back(std::move(folder));
  }
  // With its cache a copy would be taken for the user's build folder.
  paths.push_back(in_source ? build_dir + "/CMakeCache.txt" : build_dir);
  return paths;
}

}  // namespace tzc::rewriter
