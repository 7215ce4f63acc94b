// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/cmake_project.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

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
                                            "option",
                                            "function",
                                            "macro",
                                            "endfunction",
                                            "endmacro",
                                            "add_subdirectory",
                                            "set_property"};

/// cuda_add_executable, cs_add_library
bool is_special_maker(const std::string& name) {
  for (const std::string maker : {"_add_executable", "_add_library"})
    if (name.size() > maker.size() && name.compare(name.size() - maker.size(), maker.size(), maker) == 0)
      return true;
  return false;
}

class Loader {
 public:
  Expected<CmakeProject> load(const std::string& package_dir) {
    package_dir_ = package_dir;
    if (Expected<void> done = read(package_dir + "/CMakeLists.txt", CmakeValues(), {}); !done)
      return done.error();
    return std::move(project_);
  }

 private:
  Expected<void> read(const std::string& path, CmakeValues values, std::vector<std::size_t> parents) {
    const fs::path folder = fs::path(path).parent_path();
    const std::size_t index = project_.files.size();
    if (Expected<void> added = add(path, parents); !added) return added;
    parents.push_back(index);
    learn(index, folder, values, parents);
    const std::size_t end = project_.files.size();  // behind it stands what it includes
    for (std::size_t i = index; i < end; ++i)
      if (Expected<void> done = read_children(i, folder, values, parents); !done) return done;
    return {};
  }

  /// As the last file of the project; its values are yet to come.
  Expected<void> add(const std::string& path, const std::vector<std::size_t>& parents) {
    const Expected<std::string> content = read_file(path);
    if (!content) return content.error();
    const Expected<std::vector<CmakeCommand>> commands = parse_cmake(*content, path);
    if (!commands) return commands.error();
    project_.files.push_back({canonical_path(path), *content, *commands, {}, parents, {}});
    return {};
  }

  /// What the file's commands, and those of what it includes, give to variables. `folder`: of the CMakeLists.txt that it is or that includes it,
  /// `within`: that file and those above.
  void learn(std::size_t index, const fs::path& folder, CmakeValues& values,
             const std::vector<std::size_t>& within) {
    const std::vector<CmakeCommand> commands = project_.files[index].commands;
    const std::string own_folder = fs::path(project_.files[index].path).parent_path();
    for (const CmakeCommand& command : commands) {
      values.learn(command);
      if (command.name != "include" || command.arguments.empty()) continue;
      for (const std::string& file : values.expand(command.arguments[0].text)) {
        include((folder / with_folders(file, folder, own_folder)).lexically_normal(), folder, values, within);
        for (const std::string& path : values.expand("${CMAKE_MODULE_PATH}"))  // include(nodes)
          include((folder / with_folders(path, folder, own_folder) / (file + ".cmake")).lexically_normal(),
                  folder, values, within);
      }
    }
    project_.files[index].values = values;
  }

  /// A file of the package whose commands run as if they stood there. One that cannot be read, or that is CMake's, is none.
  void include(const std::string& path, const fs::path& folder, CmakeValues& values,
               const std::vector<std::size_t>& within) {
    if (!is_below(path, package_dir_) || !is_there(path) || !seen_.insert(canonical_path(path)).second)
      return;
    const std::size_t index = project_.files.size();
    if (!add(path, within)) return;
    for (const std::size_t includer : within) project_.files[includer].included.push_back(index);
    learn(index, folder, values, within);
  }

  /// ${CMAKE_CURRENT_SOURCE_DIR}/cmake/nodes.cmake
  std::string with_folders(std::string file, const std::string& folder, const std::string& own_folder) const {
    const std::pair<std::string, std::string> folders[] = {{"${CMAKE_CURRENT_SOURCE_DIR}", folder},
                                                           {"${CMAKE_CURRENT_LIST_DIR}", own_folder},
                                                           {"${PROJECT_SOURCE_DIR}", package_dir_},
                                                           {"${CMAKE_SOURCE_DIR}", package_dir_}};
    for (const auto& [variable, value] : folders)
      if (file.rfind(variable, 0) == 0) file.replace(0, variable.size(), value);
    return file;
  }

  /// Of a CMakeLists.txt, or of a file that one in `folder` includes.
  Expected<void> read_children(std::size_t index, const fs::path& folder, const CmakeValues& values,
                               const std::vector<std::size_t>& parents) {
    const std::vector<CmakeCommand> commands = project_.files[index].commands;  // further files move it
    const std::string own_folder = fs::path(project_.files[index].path).parent_path();
    for (const CmakeCommand& command : commands) {
      if (command.name != "add_subdirectory" || command.arguments.empty()) continue;
      for (const std::string& name : values.expand(command.arguments[0].text)) {
        const fs::path subfolder = folder / with_folders(name, folder, own_folder);
        const std::string child = (subfolder / "CMakeLists.txt").lexically_normal();
        if (!is_there(child) || !seen_.insert(canonical_path(child)).second) continue;
        if (Expected<void> done = read(child, values, parents); !done) return done;
      }
    }
    return {};
  }

  std::string package_dir_;
  CmakeProject project_;
  std::set<std::string> seen_;
};

bool names_target(const CmakeListFile& file, const CmakeCommand& command, const std::string& target) {
  return !command.arguments.empty() && file.values.may_be(command.arguments[0].text, target);
}

bool is_definition(const CmakeCommand& command, const std::string& name) {
  const bool defines = command.name == "macro" || command.name == "function";
  return defines && !command.arguments.empty() && lower_case(command.arguments[0].text) == name;
}

/// Commands of that name in the body of a macro or function that is called with a target first: target_link_libraries(${NAME} ...)
void add_of_body(const CmakeListFile& file, std::size_t definition, const std::string& name,
                 std::vector<CmakeCommandRef>& found) {
  const std::vector<CmakeArgument>& parameters = file.commands[definition].arguments;
  const std::string first = parameters.size() > 1 ? "${" + parameters[1].text + "}" : "${ARGV0}";
  for (std::size_t i = definition + 1; i < file.commands.size(); ++i) {
    const CmakeCommand& command = file.commands[i];
    if (command.name == "endmacro" || command.name == "endfunction") return;
    const bool of_target = !command.arguments.empty() &&
                           (command.arguments[0].text == first || command.arguments[0].text == "${ARGV0}");
    if (command.name == name && of_target) found.push_back({&file, &command});
  }
}

/// What the package's own macro or function of that name does.
void add_of_macro(const CmakeProject& project, const std::string& macro, const std::string& name,
                  std::vector<CmakeCommandRef>& found) {
  for (const CmakeListFile& file : project.files)
    for (std::size_t i = 0; i < file.commands.size(); ++i)
      if (is_definition(file.commands[i], macro)) add_of_body(file, i, name, found);
}

/// if(TARGET engine)
bool asks_for(const CmakeListFile& file, const CmakeCommand& condition, const std::string& target) {
  const std::vector<CmakeArgument>& asked = condition.arguments;
  return condition.name == "if" && asked.size() == 2 && asked[0].text == "TARGET" &&
         file.values.may_be(asked[1].text, target);
}

/// Whether an include() brings the file into a CMakeLists.txt.
bool is_included(const CmakeProject& project, std::size_t file) {
  const std::vector<std::size_t>& parents = project.files[file].parents;
  if (parents.empty()) return false;
  const std::vector<std::size_t>& included = project.files[parents.back()].included;
  return std::find(included.begin(), included.end(), file) != included.end();
}

/// The branches and loops that a command stands in, outermost first, each by the offset of the command that begins it; not a condition that asks
/// for the target.
std::vector<std::size_t> blocks_around(const CmakeCommandRef& ref, const std::string& target) {
  static const std::set<std::string> begin{"if", "foreach", "while"}, change{"elseif", "else"},
      end{"endif", "endforeach", "endwhile"};
  constexpr std::size_t no_condition = std::string::npos;
  std::vector<std::size_t> blocks;
  for (const CmakeCommand& command : ref.file->commands) {
    if (&command == ref.command) break;
    if (begin.count(command.name))
      blocks.push_back(asks_for(*ref.file, command, target) ? no_condition : command.begin);
    if (blocks.empty()) continue;
    if (change.count(command.name)) blocks.back() = command.begin;
    if (end.count(command.name)) blocks.pop_back();
  }
  blocks.erase(std::remove(blocks.begin(), blocks.end(), no_condition), blocks.end());
  return blocks;
}

/// Whether a command stands in a macro or function: it runs where that is called.
bool is_in_body(const CmakeCommandRef& ref) {
  bool is_inside = false;
  for (const CmakeCommand& command : ref.file->commands) {
    if (&command == ref.command) break;
    if (command.name == "macro" || command.name == "function") is_inside = true;
    if (command.name == "endmacro" || command.name == "endfunction") is_inside = false;
  }
  return is_inside;
}

/// Whether a command runs before all that its file makes by other files.
bool runs_before_other_files(const CmakeCommandRef& ref) {
  return std::none_of(ref.file->commands.begin(), ref.file->commands.end(), [&](const CmakeCommand& command) {
    const bool is_other_file =
        command.name == "add_subdirectory" || command.name == "subdirs" || command.name == "include";
    return is_other_file && command.begin < ref.command->begin;
  });
}

/// Whether the folder that makes a target is the command's, and makes it behind it, or one that is added behind it.
bool runs_before(const CmakeProject& project, const CmakeCommandRef& ref, const CmakeCommandRef& maker) {
  if (ref.file == maker.file) return ref.command->begin < maker.command->begin;
  const auto is_file = [&](std::size_t parent) { return &project.files[parent] == ref.file; };
  return std::any_of(maker.file->parents.begin(), maker.file->parents.end(), is_file) &&
         runs_before_other_files(ref);
}

/// The calls of catkin_simple() that run in any case. None where something may take back what they do, or is another catkin_simple.
std::vector<CmakeCommandRef> certain_calls_of_catkin_simple(const CmakeProject& project) {
  std::vector<CmakeCommandRef> calls;
  bool is_found = false;
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands) {
      if (is_definition(command, "catkin_simple")) return {};
      if (find_argument(command, "INCLUDE_DIRECTORIES") != std::string::npos) return {};  // set_property
      const bool finds = command.name == "find_package" && find_argument(command, "catkin_simple") == 0;
      is_found = is_found || finds;
      const CmakeCommandRef call{&file, &command};
      if (command.name == "catkin_simple" && always_runs(call) && !is_in_body(call)) calls.push_back(call);
    }
  return is_found ? calls : std::vector<CmakeCommandRef>();
}

}  // namespace

bool is_behind_catkin_simple(const CmakeProject& project, const std::string& target) {
  const std::vector<CmakeCommandRef> calls = certain_calls_of_catkin_simple(project);
  const std::vector<CmakeCommandRef> makers = makers_of_target(project, target);
  return !makers.empty() && std::all_of(makers.begin(), makers.end(), [&](const CmakeCommandRef& maker) {
    return !is_in_body(maker) && std::any_of(calls.begin(), calls.end(), [&](const CmakeCommandRef& call) {
      return runs_before(project, call, maker);
    });
  });
}

bool runs_with_target(const CmakeCommandRef& command, const CmakeCommandRef& maker,
                      const std::string& target) {
  const std::vector<std::size_t> blocks = blocks_around(command, target);
  if (blocks.empty() || command.file != maker.file) return blocks.empty();
  const std::vector<std::size_t> others = blocks_around(maker, target);
  return blocks.size() <= others.size() && std::equal(blocks.begin(), blocks.end(), others.begin());
}

bool always_runs(const CmakeCommandRef& command) {
  return blocks_around(command, "").empty();
}

Expected<CmakeProject> load_cmake_project(const std::string& package_dir) {
  return Loader().load(package_dir);
}

CmakeCommandRef find_target(const CmakeProject& project, const std::string& target) {
  const std::vector<CmakeCommandRef> makers = makers_of_target(project, target);
  return makers.empty() ? CmakeCommandRef() : makers.front();
}

std::vector<CmakeCommandRef> makers_of_target(const CmakeProject& project, const std::string& target) {
  std::vector<CmakeCommandRef> makers;
  for (const char* name : {"add_executable", "add_library"})
    for (const CmakeCommandRef& made : commands_of_target(project, name, target)) makers.push_back(made);
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (is_special_maker(command.name) && names_target(file, command, target))
        makers.push_back({&file, &command});
  if (!makers.empty()) return makers;
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (target_users.count(command.name) == 0 && names_target(file, command, target))
        return {{&file, &command}};
  return {};
}

std::vector<CmakeCommandRef> commands_of_target(const CmakeProject& project, const std::string& name,
                                                const std::string& target) {
  std::vector<CmakeCommandRef> found;
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands) {
      if (!names_target(file, command, target)) continue;
      if (command.name == name)
        found.push_back({&file, &command});
      else if (target_users.count(command.name) == 0)
        add_of_macro(project, command.name, name, found);
    }
  return found;
}

std::set<std::size_t> files_of_target(const CmakeProject& project, const std::string& target) {
  std::set<std::size_t> found;
  for (std::size_t i = 0; i < project.files.size(); ++i) {
    const CmakeListFile& file = project.files[i];
    const bool names =
        std::any_of(file.commands.begin(), file.commands.end(),
                    [&](const CmakeCommand& command) { return names_target(file, command, target); });
    if (!names) continue;
    found.insert(i);
    found.insert(file.parents.begin(), file.parents.end());
  }
  // include(cmake/flags.cmake) in one of them. What others include sets nothing for the target.
  for (std::size_t i = 0; i < project.files.size(); ++i)
    if (is_included(project, i) && found.count(project.files[i].parents.back()) != 0) found.insert(i);
  return found;
}

}  // namespace tzc::rewriter
