// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/tzc_by_catkin.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "buildfiles/cmake_project.h"
#include "buildfiles/find_packages.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "edits/source_text.h"
#include "proof/configuration.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

bool has_manifest(const fs::path& folder) {
  return is_there(folder / "package.xml");
}

/// That the build tree was configured for; of a tree for several packages, the one that holds the file.
std::string package_of(const CompileCommand& command) {
  const std::unique_ptr<UserBuild> user = UserBuild::find(command.directory);
  if (user && has_manifest(user->source)) return canonical_path(user->source);
  for (fs::path folder = fs::path(command.file).parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    if (has_manifest(folder)) return canonical_path(folder);
  return "";
}

/// What the commands of this name are given, in words.
std::set<std::string> words_of(const CmakeProject& project, const std::string& name) {
  std::set<std::string> words;
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (command.name == name) words.merge(file.values.expand(command));
  return words;
}

/// ${catkin_INCLUDE_DIRS}, or all that catkin_simple does by itself.
bool uses_include_folders(const CmakeProject& project) {
  return std::any_of(project.files.begin(), project.files.end(), [](const CmakeListFile& file) {
    return file.content.find("_INCLUDE_DIRS}") != std::string::npos ||
           file.content.find("catkin_simple") != std::string::npos;
  });
}

std::set<std::string> words_of_manifest(const std::string& package_dir) {
  const Expected<std::string> text = read_file(package_dir + "/package.xml");
  return text ? identifiers_in(*text) : std::set<std::string>();
}

bool is_simple(const CmakeProject& project) {
  return words_of(project, "find_package").count("catkin_simple") != 0;
}

/// As the port leaves it.
std::string ported_text(const PortedPackage& package, const CmakeListFile& file) {
  const auto changed = package.contents.find(file.path);
  return changed == package.contents.end() ? file.content : changed->second;
}

/// catkin_package(... CATKIN_DEPENDS ... tzc), or cs_export(), which takes package.xml's dependencies.
bool exports_tzc(const std::string& text, const std::string& path) {
  const Expected<std::vector<CmakeCommand>> commands = parse_cmake(text, path);
  if (!commands) return false;
  return std::any_of(commands->begin(), commands->end(), [](const CmakeCommand& command) {
    if (command.name == "cs_export") return true;
    const std::size_t depends = find_argument(command, "CATKIN_DEPENDS");
    return command.name == "catkin_package" && depends != std::string::npos &&
           find_argument(command, "tzc", depends) != std::string::npos;
  });
}

}  // namespace

TzcByCatkin::TzcByCatkin(const PortedPackage& package) : package_(package) {
  const Expected<CmakeProject> project = load_cmake_project(package.package_dir);
  if (!project) return;
  const auto is_ported = [&](const CmakeListFile& file) {
    return exports_tzc(ported_text(package_, file), file.path);
  };
  exports_ = words_of(*project, "catkin_package").count("tzc") != 0 ||
             std::any_of(project->files.begin(), project->files.end(), is_ported);
}

bool TzcByCatkin::reaches(const CompileCommand& command) {
  if (!exports_) return false;
  const std::string folder = package_of(command);
  return !folder.empty() && finds(folder);
}

bool TzcByCatkin::finds(const std::string& package_dir) {
  const Expected<CmakeProject> project = load_cmake_project(package_dir);
  if (!project || !uses_include_folders(*project)) return false;
  if (!folders_) {
    folders_.emplace();
    if (const Expected<std::vector<std::string>> all = find_packages_at(source_space(package_dir)))
      for (const std::string& folder : *all)
        if (const Expected<PackageXml> manifest = read_package_xml(folder))
          (*folders_)[manifest->name] = folder;
  }
  const std::set<std::string> found =
      is_simple(*project) ? words_of_manifest(package_dir) : words_of(*project, "find_package");
  return std::any_of(found.begin(), found.end(),
                     [this](const std::string& name) { return leads_to_ported(name); });
}

/// A package that exports that it depends on the ported one gives on what that one exports.
bool TzcByCatkin::leads_to_ported(const std::string& name) {
  if (name == package_.name) return true;
  const auto [known, is_new] = known_.emplace(name, false);
  if (!is_new) return known->second;
  const std::string folder = folder_of(name);
  if (folder.empty()) return false;
  const std::set<std::string> depends = exported_depends(folder);
  const bool leads = std::any_of(depends.begin(), depends.end(),
                                 [this](const std::string& other) { return leads_to_ported(other); });
  return known_[name] = leads;
}

std::set<std::string> TzcByCatkin::exported_depends(const std::string& package_dir) const {
  const Expected<CmakeProject> project = load_cmake_project(package_dir);
  if (!project) return {};
  return is_simple(*project) ? words_of_manifest(package_dir) : words_of(*project, "catkin_package");
}

std::string TzcByCatkin::folder_of(const std::string& name) {
  const auto found = folders_->find(name);
  return found == folders_->end() ? "" : found->second;
}

}  // namespace tzc::rewriter
