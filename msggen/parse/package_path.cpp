// SPDX-License-Identifier: BSD-3-Clause
#include "parse/package_path.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "parse/folders.h"
#include "parse/source.h"
#include "parse/text.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

bool has_definitions(const fs::path& folder) {
  return is_folder(folder / "msg") || is_folder(folder / "srv") || is_folder(folder / "action") ||
         !folders_named_by_genmsg(folder.string()).empty();
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

std::vector<std::string> environment_list(const char* name) {
  const char* const value = std::getenv(name);
  return split(value ? value : "", ':');
}

std::string cleaned(const std::string& folder) {
  std::string path = fs::path(folder).lexically_normal().string();
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

}  // namespace

PackageIndex::PackageIndex(const std::vector<std::string>& folders) {
  for (const std::string& given : folders) {
    const std::string folder = cleaned(given);
    if (fs::path(folder).filename() == "share") {
      add_install_space(folder);
    } else {
      add_tree(folder);
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
    if (is_file(folder / "package.xml") || has_genmsg_file(folder.string()))
      add_package(folder.string(), true);
  }
}

// Like rospack: does not enter packages and folders with CATKIN_IGNORE.
void PackageIndex::add_tree(const std::string& root) {
  walk_folders(root, [this](const std::string& folder) {
    return !is_file(fs::path(folder) / "CATKIN_IGNORE") && !add_package(folder, false);
  });
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
  std::vector<std::string> folders = environment_list("ROS_PACKAGE_PATH");
  for (const std::string& prefix : environment_list("CMAKE_PREFIX_PATH"))
    folders.push_back(prefix + "/share");
#ifdef TZC_ROS_SHARE
  folders.push_back(TZC_ROS_SHARE);
#endif
  return folders;
}

}  // namespace tzc::msggen
