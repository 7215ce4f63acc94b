// SPDX-License-Identifier: BSD-3-Clause
#include <clang/Tooling/ArgumentsAdjusters.h>
#include <clang/Tooling/JSONCompilationDatabase.h>
#include <llvm/Support/Path.h>

#include <cstdlib>
#include <set>

#include "edits/dual.h"
#include "facts/parse.h"

namespace tzc::rewriter {
namespace {

std::string canonical(const std::string& path) {
  char* real = ::realpath(path.c_str(), nullptr);
  if (!real) return path;
  const std::string result = real;
  std::free(real);
  return result;
}

bool lies_in(const std::string& file, const std::string& dir) {
  return file.rfind(dir + "/", 0) == 0;
}

bool is_cxx(const std::string& file) {
  static const std::set<std::string> extensions = {".cpp", ".cc", ".cxx", ".c++", ".C", ".cp"};
  return extensions.count(llvm::sys::path::extension(file).str()) != 0;
}

/// `ccache g++ -c x.cpp` -> `g++ -c x.cpp`
void drop_launcher(std::vector<std::string>& arguments) {
  while (arguments.size() > 1 && arguments[1][0] != '-' && !is_cxx(arguments[1]))
    arguments.erase(arguments.begin());
}

/// TZC's headers are C++14 and the port raises what the build files ask for, so the package is read like
/// that.
void raise_to_cxx14(std::vector<std::string>& arguments) {
  static const std::set<std::string> older = {"98", "03", "0x", "11"};
  for (std::string& argument : arguments)
    if (argument.rfind("-std=", 0) == 0 && argument.size() > 7 &&
        older.count(argument.substr(argument.size() - 2)))
      argument.replace(argument.size() - 2, 2, "14");
}

std::vector<std::string> adjusted(const clang::tooling::CompileCommand& command, const std::string& file) {
  using namespace clang::tooling;
  const ArgumentsAdjuster adjust =
      combineAdjusters(getClangStripOutputAdjuster(),
                       combineAdjusters(getClangStripDependencyFileAdjuster(), getClangSyntaxOnlyAdjuster()));
  std::vector<std::string> arguments = command.CommandLine;
  if (arguments.empty()) return {};
  drop_launcher(arguments);
  raise_to_cxx14(arguments);
  arguments.push_back(std::string("-D") + dual_macro);  // a package of --dual is read as it is with TZC
  return adjust(arguments, file);
}

}  // namespace

Expected<std::vector<CompileUnit>> load_units(const std::string& package_dir, const std::string& build_dir) {
  const std::string path = build_dir + "/compile_commands.json";
  std::string why;
  const auto database = clang::tooling::JSONCompilationDatabase::loadFromFile(
      path, why, clang::tooling::JSONCommandLineSyntax::AutoDetect);
  if (!database)
    return Error{
        "no compile commands: " + why, path,
        "Build the package once with -DCMAKE_EXPORT_COMPILE_COMMANDS=ON and name its build folder with -p."};
  std::vector<CompileUnit> units;
  std::set<std::vector<std::string>> known;
  for (const clang::tooling::CompileCommand& command : database->getAllCompileCommands()) {
    llvm::SmallString<256> absolute(command.Filename);
    llvm::sys::fs::make_absolute(command.Directory, absolute);
    const std::string file = canonical(absolute.str().str());
    if (!is_cxx(file) || !lies_in(file, package_dir) || lies_in(file, build_dir)) continue;
    CompileUnit unit{file, command.Directory, adjusted(command, file)};
    if (!unit.arguments.empty() && known.insert(unit.arguments).second) units.push_back(std::move(unit));
  }
  if (units.empty())
    return Error{"none of the compile commands belongs to the package", path,
                 "Build the package " + package_dir + " in that folder, or name another one with -p."};
  return units;
}

}  // namespace tzc::rewriter
