// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/plan.h"

#include <algorithm>
#include <map>

#include "buildfiles/cmake_edits.h"
#include "buildfiles/compile_database.h"
#include "buildfiles/language_standard.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "model/codes.h"

namespace tzc::rewriter {
namespace {

void append(Edits& all, const Edits& more) {
  all.insert(all.end(), more.begin(), more.end());
}

std::string joined(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
  return text;
}

class Planner {
 public:
  explicit Planner(const BuildNeeds& needs) : needs_(needs) {}

  Expected<BuildPlan> run() {
    if (Expected<void> done = find_targets(); !done) return done.error();
    const Expected<PackageXml> package = read_package_xml(needs_.package_dir);
    if (!package) return package.error();
    package_ = *package;
    if (!package_.catkin) return by_hand(), plan_;
    if (!needs_.dual)
      if (Expected<void> done = plan_package_xml(); !done) return done.error();
    if (Expected<void> done = plan_cmake(); !done) return done.error();
    leave_what_lies_outside();
    return plan_;
  }

 private:
  Expected<void> find_targets() {
    if (needs_.main_files.empty()) return {};  // only headers of it change, which others compile
    const auto all = targets_of_files(needs_.build_dir);
    if (!all) return all.error();
    for (const std::string& file : needs_.main_files)
      if (const auto found = all->find(file); found != all->end())
        targets_.insert(found->second.begin(), found->second.end());
    return {};
  }

  void note(const char* code, const std::string& file, const std::string& text) {
    plan_.notes.push_back({code, Location{file, 1, 1}, text});
  }

  void by_hand() {
    note(codes::TZC4001, package_.path,
         "the package is not built with catkin, so its build files stay as they are; add find_package(tzc "
         "REQUIRED) and "
         "target_link_libraries(TARGET tzc::tzc) for " +
             joined(targets_));
  }

  Expected<void> plan_package_xml() {
    const Expected<std::string> content = read_file(package_.path);
    if (!content) return content.error();
    const Expected<Edits> edits = depend_on_tzc(*content, package_.path);
    if (!edits) return edits.error();
    append(plan_.edits, *edits);
    return {};
  }

  Expected<void> plan_cmake() {
    const Expected<CmakeProject> project = load_cmake_project(needs_.package_dir);
    if (!project) return project.error();
    for (const std::size_t file : files_of_targets(*project))
      append(plan_.edits, raise_to_cxx14(project->files[file]));
    const CatkinUse use = catkin_use(*project);
    if (use == CatkinUse::none)
      note(codes::TZC4002, project->files.front().path,
           "no find_package(catkin ...) was found; add tzc to the catkin components where they are listed");
    if (!needs_.dual) return plan_required(*project, use);
    plan_optional(*project);
    return {};
  }

  /// Bundled libraries in folders of their own keep their standard. All files, where it is not known which make the targets.
  std::set<std::size_t> files_of_targets(const CmakeProject& project) const {
    std::set<std::size_t> all, found;
    for (std::size_t i = 0; i < project.files.size(); ++i) all.insert(i);
    for (const std::string& target : targets_) {
      const std::set<std::size_t> of_target = files_of_target(project, target);
      if (of_target.empty()) return all;
      found.insert(of_target.begin(), of_target.end());
    }
    return found.empty() ? all : found;
  }

  /// add_subdirectory(../core), or a build file that is a link: it is not the package's.
  void leave_what_lies_outside() {
    std::set<std::string> outside;
    for (const Edit& edit : plan_.edits)
      if (!is_below(edit.file, needs_.package_dir)) outside.insert(edit.file);
    const auto is_outside = [&](const Edit& edit) { return outside.count(edit.file) != 0; };
    plan_.edits.erase(std::remove_if(plan_.edits.begin(), plan_.edits.end(), is_outside), plan_.edits.end());
    for (const std::string& file : outside)
      note(codes::TZC4002, file,
           "it lies outside of the package and stays as it is; what it gives the package's targets needs "
           "tzc, and C++14 at least");
  }

  void plan_optional(const CmakeProject& project) {
    append(plan_.edits, add_optional_tzc(project, needs_.twinless));
    for (const std::string& target : targets_)
      if (uses_own_messages()) append(plan_.edits, add_message_dependency(project, target, package_.name));
  }

  Expected<void> plan_required(const CmakeProject& project, CatkinUse use) {
    // catkin_simple takes its components from package.xml.
    if (use == CatkinUse::components) append(plan_.edits, add_component(project));
    for (const std::string& package : needs_.twinless) {
      const Expected<Edits> edits = add_foreign_messages(project, package);
      if (!edits) return edits.error();
      append(plan_.edits, *edits);
    }
    if (uses_own_messages()) append(plan_.edits, add_generator(project));
    const std::map<std::string, std::set<std::string>> users = users_of_objects(project);
    for (const std::string& target : targets_) plan_target(project, target, users.count(target) != 0);
    for (const auto& item : users)
      for (const std::string& user : item.second)
        if (targets_.count(user) == 0) append(plan_.edits, add_link(project, user));
    if (exports_edited_header(project) || exports_edited_library(project))
      append(plan_.edits, add_catkin_depends(project));
    return {};
  }

  /// Targets that link the objects of others: add_executable(node $<TARGET_OBJECTS:core>), by the others' names.
  std::map<std::string, std::set<std::string>> users_of_objects(const CmakeProject& project) const {
    std::map<std::string, std::set<std::string>> users;
    for (const CmakeListFile& file : project.files)
      for (const CmakeCommand& command : file.commands) {
        if (command.arguments.size() < 2) continue;
        const std::set<std::string> words = file.values.expand(command, 1);
        for (const std::string& target : targets_)
          if (words.count("$<TARGET_OBJECTS:" + target + ">") != 0)
            users[target].merge(file.values.expand(command.arguments[0].text));
      }
    return users;
  }

  /// `only_compiles`: others link its objects. To link it to something needs CMake 3.12.
  void plan_target(const CmakeProject& project, const std::string& target, bool only_compiles) {
    if (!find_target(project, target)) {
      note(codes::TZC4002, project.files.front().path,
           "the command that makes the target " + target +
               " was not found in this package; make sure that it includes "
               "${catkin_INCLUDE_DIRS} and links ${catkin_LIBRARIES}");
      return;
    }
    append(plan_.edits, add_include(project, target));
    if (!only_compiles) append(plan_.edits, add_link(project, target));
    if (uses_own_messages()) append(plan_.edits, add_message_dependency(project, target, package_.name));
  }

  bool uses_own_messages() const {
    const auto first = needs_.tzc_types.lower_bound(package_.name + "/");
    return first != needs_.tzc_types.end() &&
           first->compare(0, package_.name.size() + 1, package_.name + "/") == 0;
  }

  bool exports_edited_header(const CmakeProject& project) const {
    for (const std::string& folder : exported_folders(project, needs_.package_dir))
      for (const std::string& file : needs_.edited_files)
        if (file == folder || is_below(file, folder)) return true;
    return false;
  }

  /// Who links a static library links what it calls.
  bool exports_edited_library(const CmakeProject& project) const {
    const std::set<std::string> libraries = exported_libraries(project);
    return std::any_of(targets_.begin(), targets_.end(),
                       [&](const std::string& target) { return libraries.count(target) != 0; });
  }

  const BuildNeeds& needs_;
  PackageXml package_;
  std::set<std::string> targets_;
  BuildPlan plan_;
};

}  // namespace

bool makes_own_twins(const std::string& package_dir) {
  const Expected<CmakeProject> project = load_cmake_project(package_dir);
  return project && catkin_use(*project) == CatkinUse::components && add_component(*project).empty() &&
         add_generator(*project).empty();
}

Expected<BuildPlan> plan_build_files(const BuildNeeds& needs) {
  if (needs.main_files.empty() && needs.edited_files.empty()) return BuildPlan();
  return Planner(needs).run();
}

}  // namespace tzc::rewriter
