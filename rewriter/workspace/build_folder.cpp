// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/build_folder.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include "buildfiles/compile_database.h"
#include "edits/files.h"
#include "proof/cmake_cache.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

constexpr const char* database = "compile_commands.json";

bool has_database(const fs::path& folder) {
  return is_there(folder / database);
}

bool knows_package(const std::string& build_dir, const std::string& package_dir) {
  const Expected<std::set<std::string>> files = compiled_files(build_dir);
  return files &&
         std::any_of(files->begin(), files->end(), [&](auto& file) { return is_below(file, package_dir); });
}

/// Whether CMake configured it, or a folder above it.
bool is_configured(const fs::path& folder) {
  for (fs::path at = folder; at.has_relative_path(); at = at.parent_path())
    if (is_there(at / "CMakeCache.txt")) return true;
  return false;
}

/// Editors look for the database among the sources, where it often is a link: then the folder that was built in is where that
/// leads.
std::string build_folder_of(const fs::path& with_database) {
  const fs::path folder = canonical_path(with_database);
  if (is_configured(folder)) return folder;
  const fs::path linked = fs::path(canonical_path(folder / database)).parent_path();
  return has_database(linked) ? linked : folder;
}

std::string how_to_make_one(const std::string& package_dir) {
  const fs::path workspace = fs::path(source_space(package_dir)).parent_path();
  const std::string option = " -DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
                    configure = "configure the workspace with";
  if (is_there(workspace / ".catkin_tools"))
    return configure + option + ", as in: catkin config --append-args --cmake-args" + option +
           " && catkin build";
  const bool isolated = is_there(workspace / "build_isolated") && !is_there(workspace / "build");
  return configure + option + ", as in: catkin_make" + (isolated ? "_isolated" : "") + option;
}

/// What -p names: a folder, or the file in it.
fs::path named_folder(const std::string& given) {
  fs::path folder = given;
  if (folder.filename() == database) folder = folder.parent_path();
  return folder.empty() ? "." : folder;
}

/// catkin build and catkin_make_isolated have a build folder for each package, by its name.
std::vector<fs::path> given_candidates(const std::string& given, const std::string& package) {
  const fs::path folder = named_folder(given);
  return {folder, folder / package};
}

Expected<std::string> checked_build_dir(const std::string& given, const PackagePlace& package) {
  const std::vector<fs::path> folders = given_candidates(given, package.name);
  const auto found = std::find_if(folders.begin(), folders.end(), has_database);
  if (found == folders.end())
    return Error{"has no compile_commands.json", given, how_to_make_one(package.dir)};
  if (Expected<std::set<std::string>> files = compiled_files(*found); !files) return files.error();
  if (!knows_package(*found, package.dir))
    return Error{"has no compile command for any file of " + package.dir, given,
                 "configure the package in that folder"};
  return build_folder_of(*found);
}

/// Every folder that catkin's tools may have used for a package below `root`.
std::vector<fs::path> candidates(const fs::path& root, const std::string& package) {
  return {root / "build" / package,          root / "build",
          root / "build_isolated" / package, root / "build_isolated" / package / "devel",
          root / ".private" / package,       root};
}

/// The first folder that suits, walking up from the package and then from `arguments`; empty: none does.
template <class Suits>
fs::path first_candidate(const PackagePlace& package, const std::vector<std::string>& arguments,
                         const Suits& suits) {
  std::vector<fs::path> starts = {package.dir};
  for (const std::string& argument : arguments) starts.push_back(fs::absolute(argument).lexically_normal());
  for (const fs::path& start : starts)
    for (fs::path root = start; root.has_relative_path(); root = root.parent_path())
      for (const fs::path& folder : candidates(root, package.name))
        if (suits(folder)) return folder;
  return {};
}

}  // namespace

Expected<std::string> find_build_dir(const PackagePlace& package, const std::string& given,
                                     const std::vector<std::string>& arguments) {
  if (!given.empty()) return checked_build_dir(given, package);
  for (const bool only_configured : {true, false}) {
    const fs::path found = first_candidate(package, arguments, [&](const fs::path& folder) {
      return has_database(folder) && is_configured(build_folder_of(folder)) == only_configured &&
             knows_package(folder, package.dir);
    });
    if (!found.empty()) return build_folder_of(found);
  }
  return Error{"no compile_commands.json with the package's files was found", package.dir,
               how_to_make_one(package.dir) + "; or name its folder with -p"};
}

std::string find_configured_dir(const PackagePlace& package, const std::string& given,
                                const std::vector<std::string>& arguments) {
  const auto configures = [&](const fs::path& folder) {
    // CMake fills the cache while it configures, and generates only when nothing went wrong.
    const bool is_done = has_database(folder) || is_there(folder / "CMakeFiles/TargetDirectories.txt");
    if (!is_done || !is_there(folder / "CMakeCache.txt")) return false;
    const std::string source = CmakeCache::nearest(folder).value(package.name + "_SOURCE_DIR");
    return !source.empty() && canonical_path(source) == package.dir;
  };
  if (given.empty()) return first_candidate(package, arguments, configures);
  const std::vector<fs::path> folders = given_candidates(given, package.name);
  const auto found = std::find_if(folders.begin(), folders.end(), configures);
  return found == folders.end() ? "" : canonical_path(*found);
}

Expected<void> check_exports(const std::string& configured_dir, const PackagePlace& package) {
  static const std::set<std::string> off = {"", "0", "OFF", "NO", "FALSE", "N"};
  std::string value = CmakeCache::nearest(configured_dir).value("CMAKE_EXPORT_COMPILE_COMMANDS");
  std::transform(value.begin(), value.end(), value.begin(), [](unsigned char c) { return std::toupper(c); });
  if (has_database(configured_dir) || off.count(value) == 0) return {};
  return Error{
      "was configured without compile commands, so that nothing tells how the package's files are compiled",
      configured_dir, how_to_make_one(package.dir)};
}

}  // namespace tzc::rewriter
