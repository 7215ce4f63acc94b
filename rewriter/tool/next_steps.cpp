// SPDX-License-Identifier: BSD-3-Clause
#include "tool/next_steps.h"

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include "tool/places.h"
#include "tool/shell_word.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

bool is_there(const fs::path& path) {
  std::error_code unreadable;
  return fs::exists(path, unreadable);
}

/// The folder in which the workspace is built: marked by catkin's tools, or the parent of a `src` folder.
fs::path workspace_of(const fs::path& package_dir) {
  for (fs::path folder = package_dir.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (is_there(folder / ".catkin_workspace") || is_there(folder / ".catkin_tools")) return folder;
    if (folder.filename() == "src") return folder.parent_path();
  }
  return package_dir.parent_path();
}

std::string builder(const fs::path& workspace) {
  if (is_there(workspace / ".catkin_tools")) return "catkin build";
  const bool isolated = is_there(workspace / "build_isolated") && !is_there(workspace / "build");
  return isolated ? "catkin_make_isolated" : "catkin_make";
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

std::string next_steps(const std::string& package_dir) {
  const fs::path workspace = workspace_of(package_dir);
  const std::string build = "(cd " + shell_word(workspace.string()) + " && " + builder(workspace) + ")\n";
  const char* prefixes = std::getenv("CMAKE_PREFIX_PATH");
  if (environment_has_tzc(prefixes) || workspace_has_tzc(workspace) || system_has_tzc())
    return "ported; build the workspace again:\n  " + build;
  const std::string setup = own_setup_file();
  if (setup.empty())
    return "ported; catkin will not find tzc in this shell: source the setup.bash of the folder that tzc is "
           "installed in, then\n  " +
           build;
  // Without --extend a setup file forgets the workspaces that were sourced before it.
  const bool others = prefixes && *prefixes;
  return "ported; catkin will not find tzc in this shell, so type\n  source " + setup +
         (others ? " --extend" : "") + "\n  " + build;
}

}  // namespace tzc::rewriter
