// SPDX-License-Identifier: BSD-3-Clause
#include "other_code/workspace_code.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "buildfiles/find_packages.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// Packages directly in a folder.
std::vector<std::string> packages_in(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code failed, ignored;
  for (const auto& entry : fs::directory_iterator(folder, failed))
    if (fs::exists(entry.path() / "package.xml", ignored))
      found.push_back(canonical_path(entry.path().string()));
  return found;
}

/// The packages of the workspace, these among them. Of a package outside of any workspace only the folders beside it are searched: its
/// parent may be a home folder.
std::set<std::string> neighbours_of(const std::vector<SourcePackage>& packages) {
  std::set<std::string> all;
  for (const SourcePackage& package : packages) all.insert(package.dir);
  for (const std::string& space : source_spaces(packages)) {
    if (!is_workspace(space)) {
      const std::vector<std::string> beside = packages_in(space);
      all.insert(beside.begin(), beside.end());
    } else if (const Expected<std::vector<std::string>> found = find_packages_at(space)) {
      all.insert(found->begin(), found->end());
    }
  }
  return all;
}

std::vector<std::string> folders_of(const std::vector<SourcePackage>& packages) {
  std::vector<std::string> folders;
  for (const SourcePackage& package : packages) folders.push_back(package.dir);
  return folders;
}

/// All that the build trees compile: other packages' sources, and those that the build generates, too.
std::set<std::string> compiled_with(const std::vector<SourcePackage>& packages, FileAccesses* accesses) {
  std::set<std::string> all;
  for (const SourcePackage& package : packages)
    if (const Expected<std::set<std::string>> files = compiled_files(package.build_dir))
      all.insert(files->begin(), files->end());
  if (accesses)
    for (const std::string& file : all) accesses->note(file);
  return all;
}

/// Where a package of the workspace would have a build tree: beside those of the packages that are ported, and in itself.
std::set<std::string> build_dirs_of(const std::string& folder, const std::vector<SourcePackage>& packages) {
  const Expected<PackageXml> manifest = read_package_xml(folder);
  if (!manifest) return {};
  std::set<std::string> found{folder + "/build"};
  for (const SourcePackage& ported : packages)
    if (fs::path(ported.build_dir).filename() == ported.name)
      found.insert((fs::path(ported.build_dir).parent_path() / manifest->name).string());
  for (const std::string& space : source_spaces(packages))
    for (const char* builds : {"build", "build_isolated"})
      found.insert((fs::path(space).parent_path() / builds / manifest->name).string());
  return found;
}

/// Of the workspace's packages that have a build tree each, as catkin build and catkin_make_isolated make them.
std::vector<CompileCommand> commands_beside(const std::vector<SourcePackage>& packages,
                                            FileAccesses* accesses) {
  std::set<std::string> known;
  for (const SourcePackage& package : packages) known.insert(canonical_path(package.build_dir));
  std::vector<CompileCommand> all;
  for (const std::string& folder : neighbours_of(packages))
    for (const std::string& build_dir : build_dirs_of(folder, packages)) {
      if (accesses) accesses->note(build_dir + "/compile_commands.json");
      if (!known.insert(canonical_path(build_dir)).second) continue;
      if (Expected<std::vector<CompileCommand>> commands = read_compile_commands(build_dir))
        std::move(commands->begin(), commands->end(), std::back_inserter(all));
    }
  return all;
}

}  // namespace

std::set<std::string> source_spaces(const std::vector<SourcePackage>& packages) {
  std::set<std::string> spaces;
  for (const SourcePackage& package : packages) spaces.insert(source_space(package.dir));
  return spaces;
}

WorkspaceCode::WorkspaceCode(const std::vector<SourcePackage>& packages, IsLeftOut is_dead,
                             IncludeGraphs& graphs, FileAccesses* accesses)
    : is_dead_(std::move(is_dead)),
      own_(folders_of(packages)),
      compiled_(compiled_with(packages, accesses)),
      includes_(graphs.of(neighbours_of(packages))),
      commands_of_others_(commands_beside(packages, accesses)) {
  for (const std::string& file : compiled_) includes_.add_compiled(file);
}

HeaderChangeUsers WorkspaceCode::users_of(const FileContents& changed) const {
  HeaderChangeUsers users;
  const auto seems_to_use = [&](const std::string& source) {
    const std::set<std::string> reached = includes_.reached_from(source);
    return std::any_of(changed.begin(), changed.end(),
                       [&](const auto& item) { return reached.count(item.first) != 0; });
  };
  // By a link, or by its path, another package may compile a file of this one; a unity build includes it by its path.
  const auto seems_to_compile = [&](const CompileCommand& command) {
    std::vector<std::string> sources = unity_sources(command.file);
    sources.push_back(command.canonical);
    return std::any_of(sources.begin(), sources.end(), [&](const std::string& source) {
      return changed.count(source) != 0 || seems_to_use(source);
    });
  };
  if (changed.empty()) return users;
  for (const std::string& source : compiled_)
    if (seems_to_use(source)) users.sources.insert(source);
  std::copy_if(commands_of_others_.begin(), commands_of_others_.end(), std::back_inserter(users.commands),
               seems_to_compile);
  return users;
}

CastsElsewhere WorkspaceCode::casts_elsewhere() const {
  const std::set<std::string> others = packages_that_may_be_given(own_, includes_, is_dead_);
  std::set<std::string> files;
  for (const std::string& file : includes_.code())
    if (const std::string* package = includes_.packages().of(file); package && others.count(*package) != 0)
      if (!is_dead_(file)) files.insert(file);
  return {includes_.packages(), files};
}

std::optional<Location> WorkspaceCode::cast_elsewhere(const std::string& type) const {
  if (!casts_) casts_.emplace(casts_elsewhere());
  return casts_->of(type);
}

}  // namespace tzc::rewriter
