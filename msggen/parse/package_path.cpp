// SPDX-License-Identifier: BSD-3-Clause
#include "parse/package_path.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "parse/source.h"
#include "parse/text.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 16;

std::vector<fs::path> entries(const fs::path& folder) {
  std::error_code ignored;
  std::vector<fs::path> result;
  for (fs::directory_iterator it(folder, fs::directory_options::skip_permission_denied, ignored), end;
       !ignored && it != end; it.increment(ignored)) {
    result.push_back(it->path());
  }
  std::sort(result.begin(), result.end());
  return result;
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

bool has_definitions(const fs::path& folder) {
  return is_folder(folder / "msg") || is_folder(folder / "srv") || is_folder(folder / "action");
}

// The first <name> of a package.xml is the package's; a missing or odd one falls back to the folder's name.
std::string package_name(const fs::path& folder) {
  std::ifstream in(folder / "package.xml");
  std::string xml{std::istreambuf_iterator<char>(in), {}};
  const std::size_t start = xml.find("<name>"),
                    end = xml.find("</name>", start == std::string::npos ? 0 : start);
  if (start == std::string::npos || end == std::string::npos) return folder.filename().string();
  return std::string(strip(std::string_view(xml).substr(start + 6, end - start - 6)));
}

std::vector<std::string> split(const char* list) {
  std::vector<std::string> result;
  std::string_view rest = list ? list : "";
  while (!rest.empty()) {
    const std::size_t colon = rest.find(':');
    if (colon != 0) result.emplace_back(rest.substr(0, colon));
    rest.remove_prefix(colon == std::string_view::npos ? rest.size() : colon + 1);
  }
  return result;
}

void add_files(const fs::path& folder, const char* extension, std::vector<std::string>& files) {
  for (const fs::path& path : entries(folder)) {
    if (path.extension() == extension && is_file(path)) files.push_back(path.string());
  }
}

void add_folders(const fs::path& folder, int depth, std::vector<std::string>& folders) {
  folders.push_back(folder.string());
  if (depth == deepest) return;
  for (const fs::path& inner : entries(folder)) {
    const bool is_hidden = inner.filename().string().front() == '.';
    if (is_folder(inner) && !fs::is_symlink(inner) && !is_hidden) add_folders(inner, depth + 1, folders);
  }
}

std::string cleaned(const std::string& folder) {
  std::string path = fs::path(folder).lexically_normal().string();
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

}  // namespace

std::vector<std::string> Package::message_directories() const {
  std::vector<std::string> folders;
  add_folders(message_directory(), 0, folders);
  return folders;
}

std::vector<std::string> Package::definition_files() const {
  std::vector<std::string> files, actions;
  for (const std::string& folder : message_directories()) add_files(folder, ".msg", files);
  std::set<std::string> messages;
  for (const std::string& file : files) messages.insert(fs::path(file).stem().string());
  add_files(fs::path(directory) / "srv", ".srv", files);
  add_files(fs::path(directory) / "action", ".action", actions);
  for (const std::string& action : actions) {
    if (!messages.count(fs::path(action).stem().string() + "Action")) files.push_back(action);
  }
  return files;
}

PackageIndex::PackageIndex(const std::vector<std::string>& folders) {
  for (const std::string& given : folders) {
    const std::string folder = cleaned(given);
    if (fs::path(folder).filename() == "share") {
      add_install_space(folder);
    } else {
      add_tree(folder, 0);
    }
  }
}

const Package* PackageIndex::find(const std::string& name) const {
  auto found = packages_.find(name);
  return found == packages_.end() ? nullptr : &found->second;
}

// Some distributions put package.xml into another package than the definitions; genmsg's CMake file is with
// them.
void PackageIndex::add_install_space(const std::string& share) {
  for (const fs::path& folder : entries(share)) {
    const fs::path genmsg_file = folder / "cmake" / (folder.filename().string() + "-msg-paths.cmake");
    if (is_file(folder / "package.xml") || is_file(genmsg_file)) add_package(folder.string(), true);
  }
}

// Like rospack: does not enter packages, hidden folders, and folders with CATKIN_IGNORE.
void PackageIndex::add_tree(const std::string& folder, int depth) {
  if (depth > deepest || is_file(fs::path(folder) / "CATKIN_IGNORE")) return;
  if (add_package(folder, false)) return;
  for (const fs::path& inner : entries(folder)) {
    if (is_folder(inner) && !fs::is_symlink(inner) && inner.filename().string().front() != '.') {
      add_tree(inner.string(), depth + 1);
    }
  }
}

bool PackageIndex::add_package(const std::string& folder, bool installed) {
  std::optional<Package> package = package_in(folder);
  if (!package) return false;
  Package& first = packages_.emplace(package->name, *package).first->second;
  first.installed |= installed;
  return true;
}

std::optional<Package> package_in(const std::string& folder) {
  const fs::path path = fs::absolute(cleaned(folder));
  if (is_file(path / "package.xml")) return Package{package_name(path), cleaned(folder)};
  if (has_definitions(path)) return Package{path.filename().string(), cleaned(folder)};
  return std::nullopt;
}

std::vector<std::string> ros_package_path() {
  std::vector<std::string> folders = split(std::getenv("ROS_PACKAGE_PATH"));
  for (const std::string& prefix : split(std::getenv("CMAKE_PREFIX_PATH")))
    folders.push_back(prefix + "/share");
#ifdef TZC_ROS_SHARE
  folders.push_back(TZC_ROS_SHARE);
#endif
  return folders;
}

}  // namespace tzc::msggen
