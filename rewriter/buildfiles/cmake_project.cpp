// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/cmake_project.h"

#include <filesystem>
#include <set>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// Commands that have a target's name as first argument without making it.
const std::set<std::string> target_users = {"target_link_libraries",
                                            "find_package",
                                            "include",
                                            "target_include_directories",
                                            "target_compile_definitions",
                                            "target_compile_features",
                                            "target_compile_options",
                                            "target_link_options",
                                            "target_sources",
                                            "set_target_properties",
                                            "add_dependencies",
                                            "install",
                                            "set",
                                            "project",
                                            "foreach",
                                            "list",
                                            "message",
                                            "if",
                                            "elseif",
                                            "set_property"};

class Loader {
 public:
  Expected<CmakeProject> load(const std::string& package_dir) {
    if (Expected<void> done = read(package_dir + "/CMakeLists.txt", CmakeValues(), {}); !done)
      return done.error();
    return std::move(project_);
  }

 private:
  Expected<void> read(const std::string& path, CmakeValues values, std::vector<std::size_t> parents) {
    Expected<std::string> content = read_file(path);
    if (!content) return content.error();
    Expected<std::vector<CmakeCommand>> commands = parse_cmake(*content, path);
    if (!commands) return commands.error();
    for (const CmakeCommand& command : *commands) values.learn(command);

    const std::size_t index = project_.files.size();
    project_.files.push_back({path, *content, *commands, values, parents});
    parents.push_back(index);
    return read_children(*commands, fs::path(path).parent_path(), values, parents);
  }

  Expected<void> read_children(const std::vector<CmakeCommand>& commands, const fs::path& folder,
                               const CmakeValues& values, const std::vector<std::size_t>& parents) {
    for (const CmakeCommand& command : commands) {
      if (command.name != "add_subdirectory" || command.arguments.empty()) continue;
      for (const std::string& name : values.expand(command.arguments[0].text)) {
        const std::string child = (folder / name / "CMakeLists.txt").lexically_normal();
        if (!fs::exists(child) || !seen_.insert(child).second) continue;
        if (Expected<void> done = read(child, values, parents); !done) return done;
      }
    }
    return {};
  }

  CmakeProject project_;
  std::set<std::string> seen_;
};

bool names_target(const CmakeListFile& file, const CmakeCommand& command, const std::string& target) {
  return !command.arguments.empty() && file.values.may_be(command.arguments[0].text, target);
}

}  // namespace

Expected<CmakeProject> load_cmake_project(const std::string& package_dir) {
  return Loader().load(package_dir);
}

CmakeCommandRef find_target(const CmakeProject& project, const std::string& target) {
  for (const char* name : {"add_executable", "add_library"})
    if (const auto made = commands_of_target(project, name, target); !made.empty()) return made.front();
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (!target_users.count(command.name) && names_target(file, command, target)) return {&file, &command};
  return {};
}

std::vector<CmakeCommandRef> commands_of_target(const CmakeProject& project, const std::string& name,
                                                const std::string& target) {
  std::vector<CmakeCommandRef> found;
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (command.name == name && names_target(file, command, target)) found.push_back({&file, &command});
  return found;
}

}  // namespace tzc::rewriter
