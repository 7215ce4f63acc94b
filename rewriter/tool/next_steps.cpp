// SPDX-License-Identifier: BSD-3-Clause
#include "tool/next_steps.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "edits/files.h"
#include "port/shell_word.h"
#include "proof/cmake_cache.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// The folder in which the workspace is built: marked by catkin's tools, or the parent of a `src` folder.
fs::path workspace_of(const fs::path& package_dir) {
  for (fs::path folder = package_dir.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (is_there(folder / ".catkin_workspace") || is_there(folder / ".catkin_tools")) return folder;
    if (folder.filename() == "src") return folder.parent_path();
  }
  return package_dir.parent_path();
}

std::string in_folder(const fs::path& folder, const std::string& command) {
  return "(cd " + shell_word(folder.string()) + " && " + command + ")";
}

/// Of a build folder that CMake did not configure, only what lies around it tells.
std::string likely_command(const fs::path& workspace) {
  if (is_there(workspace / ".catkin_tools")) return in_folder(workspace, "catkin build");
  const bool isolated = is_there(workspace / "build_isolated") && !is_there(workspace / "build");
  return in_folder(workspace, isolated ? "catkin_make_isolated" : "catkin_make");
}

/// catkin_make configures WORKSPACE/src in WORKSPACE/build, and marks both.
bool is_of_catkin_make(const fs::path& tree, const fs::path& source) {
  const fs::path workspace = tree.parent_path();
  return tree.filename() == "build" && source == canonical_path(workspace / "src") &&
         (is_there(tree / ".built_by") || is_there(workspace / ".catkin_workspace"));
}

/// The command that builds what CMake has configured there. The tools of catkin are told by where they put a package; whoever
/// configured it otherwise builds it with CMake.
std::string command_of(const CmakeCache& cache) {
  const fs::path tree = cache.folder(), above = tree.parent_path(), workspace = above.parent_path();
  if (is_of_catkin_make(tree, canonical_path(cache.value("CMAKE_HOME_DIRECTORY")))) {
    const bool ninja = cache.value("CMAKE_GENERATOR") == "Ninja";
    return in_folder(above, ninja ? "catkin_make --use-ninja" : "catkin_make");
  }
  if (above.filename() == "build_isolated") return in_folder(workspace, "catkin_make_isolated");
  if (is_there(workspace / ".catkin_tools")) return in_folder(workspace, "catkin build");
  return "cmake --build " + shell_word(tree.string());
}

std::string build_command(const BuiltPackage& package) {
  const CmakeCache cache = CmakeCache::nearest(package.build_dir);
  return cache.empty() ? likely_command(workspace_of(package.dir)) : command_of(cache);
}

/// Each once; packages of one workspace are built together.
std::string build_commands(const std::vector<BuiltPackage>& packages) {
  std::vector<std::string> commands;
  std::string lines;
  for (const BuiltPackage& package : packages) {
    std::string command = build_command(package);
    if (std::find(commands.begin(), commands.end(), command) != commands.end()) continue;
    lines += "  " + command + "\n";
    commands.push_back(std::move(command));
  }
  return lines;
}

bool has_tzc(const fs::path& prefix) {
  return is_there(prefix / "share/tzc/cmake/tzcConfig.cmake");
}

/// Debian's multiarch folders.
bool system_has_tzc() {
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator("/usr/lib", unreadable))
    if (is_there(entry.path() / "cmake/tzc/tzcConfig.cmake")) return true;
  return has_tzc("/usr") || has_tzc("/usr/local");
}

/// tzc may be a member of the workspace.
bool workspace_has_tzc(const fs::path& workspace) {
  for (const char* space : {"devel", "devel/.private/tzc", "devel_isolated/tzc"})
    if (has_tzc(workspace / space)) return true;
  return false;
}

bool environment_has_tzc(const char* prefixes) {
  std::istringstream list(prefixes ? prefixes : "");
  for (std::string prefix; std::getline(list, prefix, ':');)
    if (!prefix.empty() && has_tzc(prefix)) return true;
  return false;
}

/// The setup file of the installation or build tree that this program belongs to; empty: none.
std::string own_setup_file() {
  const fs::path bin = own_folder();
  for (const char* prefix : {"..", "../devel"})
    if (const fs::path root = bin / prefix; has_tzc(root) && is_there(root / "setup.bash"))
      return (root / "setup.bash").lexically_normal();
  return "";
}

}  // namespace

std::string next_steps(const std::vector<BuiltPackage>& packages) {
  const std::string build = build_commands(packages);
  const char* prefixes = std::getenv("CMAKE_PREFIX_PATH");
  if (environment_has_tzc(prefixes) || workspace_has_tzc(workspace_of(packages.front().dir)) ||
      system_has_tzc())
    return "ported; build again:\n" + build;
  const std::string setup = own_setup_file();
  if (setup.empty())
    return "ported; catkin will not find tzc in this shell: source the setup.bash of the folder that tzc is "
           "installed in, then\n" +
           build;
  // Without --extend a setup file forgets the workspaces that were sourced before it.
  const bool others = prefixes && *prefixes;
  return "ported; catkin will not find tzc in this shell, so type\n  source " + setup +
         (others ? " --extend" : "") + "\n" + build;
}

}  // namespace tzc::rewriter
