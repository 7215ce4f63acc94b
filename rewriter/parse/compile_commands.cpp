// SPDX-License-Identifier: BSD-3-Clause
#include "parse/compile_commands.h"

#include <algorithm>
#include <regex>
#include <set>

#include "buildfiles/build_trees.h"
#include "buildfiles/compile_database.h"
#include "edits/dual.h"
#include "edits/files.h"
#include "edits/standard_flags.h"

namespace tzc::rewriter {
namespace {

/// arm-linux-gnueabihf-g++-12, /usr/bin/c++, clang++
bool is_compiler(const std::string& word) {
  static const std::regex name("(.*[/-])?(c\\+\\+|cc|g\\+\\+|gcc|clang|clang\\+\\+|icpc|icpx)(-[0-9.]+)?");
  return std::regex_match(word, name);
}

/// `ccache g++ -c x.cpp`, `cmake -E env CCACHE_DIR=/c ccache g++ -c x.cpp` -> `g++ -c x.cpp`
void drop_launcher(std::vector<std::string>& arguments) {
  const auto source = std::find_if(arguments.begin(), arguments.end(), is_cpp_source);
  const auto compiler = std::find_if(arguments.begin(), source, is_compiler);
  if (compiler != source) arguments.erase(arguments.begin(), compiler);
  const auto is_program = [](const std::string& word) {
    return !word.empty() && word[0] != '-' && word[0] != '@' && !is_cpp_source(word);
  };
  while (arguments.size() > 1 && is_program(arguments[1])) arguments.erase(arguments.begin());
}

/// TZC's headers are C++14 and the port raises the standard in the build files, so the package is parsed with
/// it.
std::vector<std::string> adjusted(const CompileCommand& command) {
  std::vector<std::string> arguments = without_outputs(command.arguments);
  if (arguments.empty()) return {};
  drop_launcher(arguments);
  std::transform(arguments.begin(), arguments.end(), arguments.begin(), raised_standard);
  arguments.push_back(std::string("-D") + dual_macro);  // a package of --dual is read as it is with TZC
  arguments.push_back("-fsyntax-only");
  return arguments;
}

/// A unit of a unity build lies in the build folder and includes the package's sources.
bool belongs_to(const CompileCommand& command, const std::string& package_dir, const FolderSet& generated) {
  const auto in_package = [&](const std::string& file) { return is_below(file, package_dir); };
  const std::vector<std::string> sources = unity_sources(command.file);
  if (!sources.empty()) return std::any_of(sources.begin(), sources.end(), in_package);
  return is_cpp_source(command.canonical) && in_package(command.canonical) &&
         !generated.hold(command.canonical);
}

}  // namespace

Expected<std::vector<CompileUnit>> load_units(const std::string& package_dir, const std::string& build_dir) {
  const std::string path = build_dir + "/compile_commands.json";
  const Expected<std::vector<CompileCommand>> commands = read_compile_commands(build_dir);
  if (!commands)
    return Error{
        "no compile commands: " + commands.error().what, path,
        "Build the package once with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON and name its build folder with -p."};
  const FolderSet generated = generated_folders(build_dir, package_dir);
  std::vector<CompileUnit> units;
  std::set<std::vector<std::string>> known;
  for (const CompileCommand& command : *commands) {
    if (!belongs_to(command, package_dir, generated)) continue;
    CompileUnit unit{command.canonical, command.directory, adjusted(command)};
    if (!unit.arguments.empty() && known.insert(unit.arguments).second) units.push_back(std::move(unit));
  }
  if (units.empty())
    return Error{"none of the compile commands belongs to the package", path,
                 "Build the package " + package_dir + " in that folder, or name another one with -p."};
  return units;
}

}  // namespace tzc::rewriter
