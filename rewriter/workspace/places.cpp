// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/places.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "edits/files.h"
#include "proof/cmake_cache.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// A build tree lists where its headers are: in its devel space, of which this program is part or a neighbour.
std::vector<fs::path> build_tree_includes(const fs::path& bin) {
  std::vector<fs::path> folders;
  for (const char* devel : {"..", "../devel"}) {
    const Expected<std::string> list = read_file(bin / devel / "share/tzc/include_folders");
    std::istringstream lines(list ? *list : "");
    for (std::string line; std::getline(lines, line);) folders.push_back(line);
  }
  return folders;
}

std::vector<std::string> split_path(const char* list) {
  std::vector<std::string> parts;
  std::istringstream stream(list ? list : "");
  for (std::string part; std::getline(stream, part, ':');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

std::vector<fs::path> own_include_folders() {
  const fs::path bin = own_folder();
  std::vector<fs::path> places = {bin / "../include"};  // bin
  places.push_back(bin / "../../include");              // lib/tzc
  for (const fs::path& place : build_tree_includes(bin)) places.push_back(place);
  return places;
}

/// Debian's libraries lie in a folder for the architecture.
bool has_cmake_package(const fs::path& prefix) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(prefix / "lib", ignored))
    if (fs::exists(entry.path() / "cmake/tzc/tzcConfig.cmake", ignored)) return true;
  return fs::exists(prefix / "share/tzc/cmake/tzcConfig.cmake", ignored) ||
         fs::exists(prefix / "lib/cmake/tzc/tzcConfig.cmake", ignored);
}

}  // namespace

std::string user_folder(const char* variable, const char* in_home) {
  const char* folder = std::getenv(variable);
  if (folder && fs::path(folder).is_absolute()) return folder;
  const char* home = std::getenv("HOME");
  return home && fs::path(home).is_absolute() ? (fs::path(home) / in_home).string() : "";
}

namespace {

/// By catkin_make, catkin build or catkin_make_isolated, beside the source space.
bool is_marked(const fs::path& space) {
  const char* const marks[] = {".catkin_workspace", ".catkin_tools", "build_isolated"};
  return std::any_of(std::begin(marks), std::end(marks),
                     [&](const char* mark) { return is_there(space.parent_path() / mark); });
}

}  // namespace

std::string source_space(const std::string& package_dir) {
  fs::path marked, named;
  for (fs::path folder = fs::path(package_dir).parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    if (is_marked(folder)) marked = folder;
    if (named.empty() && folder.filename() == "src") named = folder;
  }
  if (marked.empty() && named.empty()) return fs::path(package_dir).parent_path();
  return marked.empty() ? named : marked;
}

bool is_workspace(const std::string& source_space) {
  return fs::path(source_space).filename() == "src" || is_marked(source_space);
}

std::vector<std::string> share_folders(const std::string& build_dir) {
  std::vector<std::string> folders;
  const std::string catkin = CmakeCache::nearest(build_dir).value("catkin_DIR");
  if (!catkin.empty()) folders.push_back((fs::path(catkin) / "../..").lexically_normal());
  for (const std::string& folder : split_path(std::getenv("ROS_PACKAGE_PATH"))) folders.push_back(folder);
  for (const std::string& prefix : split_path(std::getenv("CMAKE_PREFIX_PATH")))
    folders.push_back(prefix + "/share");
  folders.push_back("/usr/share");
  return folders;
}

std::vector<std::string> find_tzc_prefixes(const std::vector<std::string>& given) {
  const fs::path bin = own_folder();
  std::vector<fs::path> places = {bin / "..", bin / "../..", bin / "../devel"};
  for (const std::string& folder : given) places.push_back(fs::path(folder) / "..");
  std::vector<std::string> prefixes;
  for (const fs::path& place : places)
    if (has_cmake_package(place)) prefixes.push_back(canonical_path(place));
  return prefixes;
}

std::string own_folder() {
  std::error_code failed;
  return fs::read_symlink("/proc/self/exe", failed).parent_path();
}

Expected<std::vector<std::string>> find_tzc_includes(const std::vector<std::string>& given) {
  const std::vector<fs::path> places =
      given.empty() ? own_include_folders() : std::vector<fs::path>(given.begin(), given.end());
  std::vector<std::string> found;
  for (const fs::path& place : places)
    if (is_there(place / "tzc")) found.push_back(canonical_path(place));
  const auto has_ros = [](const std::string& folder) { return is_there(fs::path(folder) / "tzc/ros.h"); };
  const auto main = std::find_if(found.begin(), found.end(), has_ros);
  if (main == found.end())
    return Error{"TZC's headers were not found", given.empty() ? own_folder() : given.front(),
                 "name the folder that holds tzc/ros.h with --tzc-include"};
  const auto has_twins = [](const std::string& folder) {
    return is_there(fs::path(folder) / "tzc/std_msgs");
  };
  if (std::none_of(found.begin(), found.end(), has_twins))
    return Error{"TZC's headers of the installed messages were not found", found.front(),
                 "build TZC with ROS in the environment, or name the folder that holds tzc/std_msgs with "
                 "--tzc-include"};
  std::rotate(found.begin(), main, main + 1);
  return found;
}

}  // namespace tzc::rewriter
