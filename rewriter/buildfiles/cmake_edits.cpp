// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/cmake_edits.h"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "buildfiles/insertion.h"
#include "edits/dual.h"
#include "edits/links.h"

namespace tzc::rewriter {
namespace {

const std::set<std::string> find_package_words = {
    "REQUIRED", "QUIET", "OPTIONAL_COMPONENTS", "COMPONENTS", "CONFIG", "NO_MODULE", "EXACT", "MODULE"};
const std::set<std::string> catkin_package_words = {"INCLUDE_DIRS",
                                                    "LIBRARIES",
                                                    "CATKIN_DEPENDS",
                                                    "DEPENDS",
                                                    "CFG_EXTRAS",
                                                    "EXPORTED_TARGETS",
                                                    "SKIP_CMAKE_CONFIG_GENERATION",
                                                    "SKIP_PKG_CONFIG_GENERATION"};

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

template <class Visit>
void each_command(const CmakeProject& project, const std::string& name, Visit visit) {
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (command.name == name && !command.arguments.empty()) visit(file, command);
}

std::vector<CmakeCommandRef> find_packages(const CmakeProject& project, const std::string& package) {
  std::vector<CmakeCommandRef> found;
  each_command(project, "find_package", [&](const CmakeListFile& file, const CmakeCommand& command) {
    if (command.arguments[0].text == package) found.push_back({&file, &command});
  });
  return found;
}

/// The last argument of the section that starts with the keyword at `keyword`.
std::size_t section_end(const CmakeCommand& command, std::size_t keyword,
                        const std::set<std::string>& words) {
  std::size_t last = keyword;
  while (last + 1 < command.arguments.size() && !words.count(command.arguments[last + 1].text)) ++last;
  return last;
}

/// find_package(catkin REQUIRED a b) is short for REQUIRED COMPONENTS a b.
bool has_implicit_components(const CmakeCommand& command) {
  const std::size_t required = find_argument(command, "REQUIRED");
  return required != std::string::npos && section_end(command, required, find_package_words) != required;
}

bool has_components(const CmakeCommand& command) {
  return find_argument(command, "COMPONENTS") != std::string::npos || has_implicit_components(command);
}

Edit component_edit(CmakeCommandRef ref) {
  const CmakeCommand& command = *ref.command;
  std::size_t keyword = find_argument(command, "COMPONENTS");
  if (keyword == std::string::npos && has_implicit_components(command))
    keyword = find_argument(command, "REQUIRED");
  const std::size_t last = keyword == std::string::npos ? command.arguments.size() - 1
                                                        : section_end(command, keyword, find_package_words);
  return add_argument(ref.file->path, ref.file->content, command, last,
                      keyword == std::string::npos ? "COMPONENTS tzc" : "tzc");
}

bool names_tzc_or_catkin(const std::string& value, const std::string& suffix) {
  return contains(value, "{catkin_" + suffix) || contains(value, "{tzc_" + suffix) || value == "tzc" ||
         value.compare(0, 5, "tzc::") == 0;
}

bool any_value(const CmakeCommandRef& ref, std::size_t first, const std::string& suffix) {
  const std::set<std::string> values = ref.file->values.expand(*ref.command, first);
  return std::any_of(values.begin(), values.end(),
                     [&](auto& value) { return names_tzc_or_catkin(value, suffix); });
}

bool made_by_catkin_simple(const CmakeProject& project, const std::string& target) {
  const CmakeCommandRef made = find_target(project, target);
  return made && made.command->name.compare(0, 3, "cs_") == 0;
}

enum class Reach { target, users };

/// What a target links, or those that link it get: a shared library keeps its PRIVATE ones to itself.
std::set<std::string> linked_values(const CmakeCommandRef& ref, Reach reach) {
  static const std::set<std::string> scopes{"PUBLIC",       "PRIVATE",     "INTERFACE",
                                            "LINK_PRIVATE", "LINK_PUBLIC", "LINK_INTERFACE_LIBRARIES"};
  std::set<std::string> all;
  std::string scope;
  for (std::size_t i = 1; i < ref.command->arguments.size(); ++i) {
    const std::string& text = ref.command->arguments[i].text;
    if (scopes.count(text) != 0)
      scope = text;
    else if (!contains(scope, reach == Reach::users ? "PRIVATE" : "INTERFACE"))
      all.merge(ref.file->values.expand(text));
  }
  return all;
}

bool is_linked(const CmakeProject& project, const std::string& target, Reach reach,
               std::set<std::string>& seen) {
  if (!seen.insert(target).second) return false;
  if (made_by_catkin_simple(project, target)) return true;
  for (const CmakeCommandRef& ref : commands_of_target(project, "target_link_libraries", target))
    for (const std::string& library : linked_values(ref, reach)) {
      if (names_tzc_or_catkin(library, "LIBRARIES")) return true;
      const CmakeCommandRef made = find_target(project, library);
      if (!made) continue;
      const bool is_static = find_argument(*made.command, "STATIC") != std::string::npos;
      if (is_linked(project, library, is_static ? Reach::target : Reach::users, seen)) return true;
    }
  return false;
}

/// Whether a command for the whole folder (include_directories, link_libraries) reaches the file.
bool folder_has(const CmakeProject& project, const CmakeListFile& file, const std::string& name,
                const std::string& suffix) {
  auto has = [&](const CmakeListFile& one) {
    return std::any_of(one.commands.begin(), one.commands.end(), [&](const CmakeCommand& command) {
      return command.name == name && any_value({&one, &command}, 0, suffix);
    });
  };
  const auto has_at = [&](std::size_t index) { return has(project.files[index]); };
  return has(file) || std::any_of(file.parents.begin(), file.parents.end(), has_at) ||
         std::any_of(file.included.begin(), file.included.end(), has_at) ||
         std::any_of(file.parents.begin(), file.parents.end(), [&](std::size_t parent) {
           const std::vector<std::size_t>& included = project.files[parent].included;
           return std::any_of(included.begin(), included.end(), has_at);
         });
}

/// CMake refuses a target whose libraries are linked with a keyword here and without one there.
bool has_scope(const std::vector<CmakeCommandRef>& commands) {
  static const std::set<std::string> scopes{"PUBLIC", "PRIVATE", "INTERFACE"};
  return std::any_of(commands.begin(), commands.end(), [](const CmakeCommandRef& ref) {
    return ref.command->arguments.size() > 1 && scopes.count(ref.command->arguments[1].text) != 0;
  });
}

/// Behind its last argument. What stands under INTERFACE the target itself does not get.
Edit append_value(const CmakeCommandRef& ref, const std::string& value) {
  std::string scope;
  for (const CmakeArgument& argument : ref.command->arguments)
    if (argument.text == "PUBLIC" || argument.text == "PRIVATE" || argument.text == "INTERFACE")
      scope = argument.text;
  return add_argument(ref.file->path, ref.file->content, *ref.command, ref.command->arguments.size() - 1,
                      scope == "INTERFACE" ? "PRIVATE " + value : value);
}

void add_once(Edits& all, Edit edit) {
  const bool is_new = std::none_of(all.begin(), all.end(), [&](const Edit& one) {
    return one.file == edit.file && one.offset == edit.offset && one.text == edit.text;
  });
  if (is_new) all.push_back(std::move(edit));
}

/// For each command that may make the target: appends to the target's last command of that name that runs wherever that one does, or adds
/// one behind it. Commands that name the target by a variable may each be another target's as well: it is appended to all of these.
Edits extend(const CmakeProject& project, const std::string& target, const std::string& name,
             const std::string& scope, const std::string& value) {
  const std::vector<CmakeCommandRef> present = commands_of_target(project, name, target);
  const std::vector<CmakeCommandRef> makers = makers_of_target(project, target);
  if (makers.empty() && !present.empty()) return {append_value(present.back(), value)};
  Edits edits;
  for (const CmakeCommandRef& made : makers) {
    const auto runs = [&](const CmakeCommandRef& command) { return runs_with_target(command, made, target); };
    const auto last = std::find_if(present.rbegin(), present.rend(), runs);
    const std::string written = made.command->arguments[0].text;
    if (last == present.rend())
      add_once(edits, add_command(made.file->path, made.file->content, *made.command,
                                  name + "(" + written + " " + (has_scope(present) ? "PRIVATE " : scope) +
                                      value + ")"));
    else if (last->command->arguments[0].text == target)
      add_once(edits, append_value(*last, value));
    else
      for (const CmakeCommandRef& command : present)
        if (runs(command) && command.command->arguments[0].text == last->command->arguments[0].text)
          add_once(edits, append_value(command, value));
  }
  return edits;
}

/// The last of the commands that runs in any case; the last where none does.
CmakeCommandRef last_that_runs(const std::vector<CmakeCommandRef>& commands) {
  const auto last = std::find_if(commands.rbegin(), commands.rend(), always_runs);
  return last != commands.rend() ? *last : commands.back();
}

/// A keyword with its values behind the last argument: on a line of its own where the command has several.
Edit add_section(const CmakeListFile& file, const CmakeCommand& command, const std::string& text) {
  const std::size_t end = command.arguments.back().end;
  const std::string_view content = file.content;
  if (content.substr(end, command.close - end).find('\n') != std::string_view::npos)
    return add_line(file.path, content, end, text);
  const bool one_line =
      content.substr(command.begin, end - command.begin).find('\n') == std::string_view::npos;
  const std::string gap = one_line ? " " : line_ending(content) + indentation(content, end);
  return Edit{file.path, end, 0, gap + text, {}, "build-files"};
}

}  // namespace

CatkinUse catkin_use(const CmakeProject& project) {
  if (!find_packages(project, "catkin_simple").empty()) return CatkinUse::simple;
  return find_packages(project, "catkin").empty() ? CatkinUse::none : CatkinUse::components;
}

Edits add_component(const CmakeProject& project) {
  std::vector<CmakeCommandRef> commands = find_packages(project, "catkin");
  const auto with = [](const CmakeCommandRef& ref) { return has_components(*ref.command); };
  const auto bare = std::stable_partition(commands.begin(), commands.end(), with);
  // A bare find_package(catkin) beside one with components only initialises catkin.
  commands.erase(bare == commands.begin() && !commands.empty() ? bare + 1 : bare, commands.end());
  Edits edits;
  for (const CmakeCommandRef& ref : commands)
    if (!ref.file->values.expand(*ref.command, 1).count("tzc")) edits.push_back(component_edit(ref));
  return edits;
}

Edits add_generator(const CmakeProject& project) {
  Edits edits;
  each_command(project, "generate_messages", [&](const CmakeListFile& file, const CmakeCommand& command) {
    const std::size_t keyword = find_argument(command, "LANGS");
    const std::set<std::string> values = file.values.expand(command);
    if (keyword == std::string::npos || values.count("gencpp") == 0 || values.count("gentzc") != 0) return;
    edits.push_back(add_argument(file.path, file.content, command,
                                 section_end(command, keyword, {"DEPENDENCIES"}), "gentzc"));
  });
  return edits;
}

Edits add_include(const CmakeProject& project, const std::string& target) {
  const CmakeCommandRef made = find_target(project, target);
  if (!made || made_by_catkin_simple(project, target) || is_behind_catkin_simple(project, target)) return {};
  if (folder_has(project, *made.file, "include_directories", "INCLUDE_DIRS")) return {};
  for (const CmakeCommandRef& ref : commands_of_target(project, "target_include_directories", target))
    if (any_value(ref, 1, "INCLUDE_DIRS")) return {};
  return extend(project, target, "target_include_directories", "PRIVATE ", "${tzc_INCLUDE_DIRS}");
}

Edits add_link(const CmakeProject& project, const std::string& target) {
  const CmakeCommandRef made = find_target(project, target);
  std::set<std::string> seen;
  if (!made || is_linked(project, target, Reach::target, seen)) return {};
  if (folder_has(project, *made.file, "link_libraries", "LIBRARIES")) return {};
  return extend(project, target, "target_link_libraries", "", "${tzc_LIBRARIES}");
}

Edits add_message_dependency(const CmakeProject& project, const std::string& target,
                             const std::string& package) {
  for (const CmakeCommandRef& ref : commands_of_target(project, "add_dependencies", target))
    for (const std::string& value : ref.file->values.expand(*ref.command, 1))
      if (value == "${" + package + "_EXPORTED_TARGETS}" || value == package + "_generate_messages")
        return {};
  if (made_by_catkin_simple(project, target)) return {};
  return extend(project, target, "add_dependencies", "", "${${PROJECT_NAME}_EXPORTED_TARGETS}");
}

namespace {

/// Which find what package.xml names.
std::vector<CmakeCommandRef> calls_of_catkin_simple(const CmakeProject& project) {
  std::vector<CmakeCommandRef> found;
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (command.name == "catkin_simple") found.push_back({&file, &command});
  return found;
}

}  // namespace

Expected<Edits> add_foreign_messages(const CmakeProject& project, const std::string& package) {
  for (const CmakeListFile& file : project.files)
    for (const CmakeCommand& command : file.commands)
      if (command.name == "tzc_generate_messages" && file.values.expand(command).count(package))
        return Edits();
  std::vector<CmakeCommandRef> commands = find_packages(project, "catkin");
  if (commands.empty()) commands = calls_of_catkin_simple(project);
  const std::string line = "tzc_generate_messages(" + package + ")";
  if (commands.empty())
    return Error{"no place was found for " + line, project.files.front().path + ":1",
                 "write it behind the command that finds catkin with the component tzc, then run again"};
  const CmakeCommandRef last = last_that_runs(commands);
  return Edits{add_command(last.file->path, last.file->content, *last.command, line)};
}

Edits add_optional_tzc(const CmakeProject& project, const std::set<std::string>& foreign_messages) {
  if (!find_packages(project, "tzc").empty()) return {};
  std::vector<CmakeCommandRef> commands = find_packages(project, "catkin_simple");
  if (commands.empty()) commands = find_packages(project, "catkin");
  if (commands.empty()) return {};
  const CmakeCommandRef last = last_that_runs(commands);
  const std::string& content = last.file->content;
  const std::string line = line_ending(content) + indentation(content, last.command->begin);
  std::string block =
      "find_package(tzc QUIET)" + line + "if(tzc_FOUND)" + line + "  add_definitions(-D" + dual_macro + ")";
  block += line + "  include_directories(${tzc_INCLUDE_DIRS})" + line + "  link_libraries(${tzc_LIBRARIES})";
  for (const std::string& package : foreign_messages)
    block += line + "  tzc_generate_messages(" + package + ")";
  return {add_command(last.file->path, content, *last.command, block + line + "endif()")};
}

Edits add_catkin_depends(const CmakeProject& project) {
  Edits edits;
  each_command(project, "catkin_package", [&](const CmakeListFile& file, const CmakeCommand& command) {
    const std::size_t keyword = find_argument(command, "CATKIN_DEPENDS");
    if (file.values.expand(command).count("tzc")) return;
    if (keyword != std::string::npos)
      edits.push_back(add_argument(file.path, file.content, command,
                                   section_end(command, keyword, catkin_package_words), "tzc"));
    else
      edits.push_back(add_section(file, command, "CATKIN_DEPENDS tzc"));
  });
  return edits;
}

namespace {

bool calls(const CmakeProject& project, const std::string& name) {
  return std::any_of(project.files.begin(), project.files.end(), [&](const CmakeListFile& file) {
    return std::any_of(file.commands.begin(), file.commands.end(),
                       [&](const CmakeCommand& command) { return command.name == name; });
  });
}

/// The values of a keyword of catkin_package.
std::set<std::string> section(const CmakeListFile& file, const CmakeCommand& command,
                              const std::string& keyword) {
  std::set<std::string> all;
  const std::size_t at = find_argument(command, keyword);
  if (at == std::string::npos) return all;
  for (std::size_t i = at + 1; i <= section_end(command, at, catkin_package_words); ++i)
    for (const std::string& value : file.values.expand(command.arguments[i].text)) all.insert(value);
  return all;
}

/// find_package(Eigen3), find_package(Qt5 COMPONENTS Widgets), pkg_check_modules(UVC libuvc): what they name variables by, in lower case.
std::set<std::string> found_packages(const CmakeProject& project) {
  std::set<std::string> names;
  for (const char* finder : {"find_package", "pkg_check_modules", "pkg_search_module"})
    each_command(project, finder, [&](const CmakeListFile& file, const CmakeCommand& command) {
      const std::string package = lower_case(command.arguments[0].text);
      for (const std::string& value : file.values.expand(command))
        names.insert({lower_case(value), package + lower_case(value)});
    });
  return names;
}

/// ${CATKIN_DEVEL_PREFIX}/include, ${EIGEN3_INCLUDE_DIRS}: made by the build, or another package's. Any other variable may be the
/// package's own.
bool is_elsewhere(const std::string& folder, const std::set<std::string>& packages) {
  static const std::regex variable(R"(^\$\{(CATKIN_DEVEL_PREFIX|CMAKE_BINARY_DIR|CMAKE_CURRENT_BINARY_DIR|)"
                                   R"(PROJECT_BINARY_DIR|(\w+)_INCLUDE_DIRS?)\})");
  std::smatch match;
  return std::regex_search(folder, match, variable) &&
         (!match[2].matched || packages.count(lower_case(match[2])) != 0);
}

/// With what its links lead to. A variable without a known value may be any folder of the package.
std::set<std::string> exported_folder(std::string folder, const std::string& package_dir) {
  for (const std::string name : {"${PROJECT_SOURCE_DIR}", "${CMAKE_CURRENT_SOURCE_DIR}",
                                 "${CMAKE_SOURCE_DIR}", "${CMAKE_CURRENT_LIST_DIR}"})
    if (folder.rfind(name, 0) == 0) folder.replace(0, name.size(), package_dir);
  if (folder.find("${") != std::string::npos) folder = ".";
  const std::string path = (std::filesystem::path(package_dir) / folder).lexically_normal();
  return with_links(path.back() == '/' ? path.substr(0, path.size() - 1) : path, package_dir);
}

}  // namespace

std::set<std::string> exported_libraries(const CmakeProject& project) {
  std::set<std::string> libraries;
  each_command(project, "catkin_package", [&](const CmakeListFile& file, const CmakeCommand& command) {
    libraries.merge(section(file, command, "LIBRARIES"));
  });
  return libraries;
}

std::set<std::string> exported_folders(const CmakeProject& project, const std::string& package_dir) {
  std::set<std::string> folders;
  const std::set<std::string> packages = found_packages(project);
  each_command(project, "catkin_package", [&](const CmakeListFile& file, const CmakeCommand& command) {
    for (const std::string& folder : section(file, command, "INCLUDE_DIRS"))
      if (!is_elsewhere(folder, packages)) folders.merge(exported_folder(folder, package_dir));
  });
  if (!calls(project, "catkin_package"))
    folders.merge(exported_folder("include", package_dir));  // cs_export() of catkin_simple, or a macro
  return folders;
}

}  // namespace tzc::rewriter
