// SPDX-License-Identifier: BSD-3-Clause
#include "facts/collect_unit.h"

#include <clang/AST/ASTContext.h>
#include <llvm/Support/FileSystem.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "facts/api_calls.h"
#include "facts/unit.h"
#include "report/codes.h"

namespace tzc::rewriter {
namespace {

bool lies_in(const std::string& file, const std::string& dir) {
  return file.rfind(dir + "/", 0) == 0;
}

void note_files(Unit& unit, const CompileUnit& compiled, const CollectOptions& options) {
  const clang::SourceManager& manager = unit.source.manager();
  // Over the places where files were entered: to ask for each file where it was takes the square of that.
  for (unsigned i = 1; i < manager.local_sloc_entry_size(); ++i) {
    const clang::SrcMgr::SLocEntry& entry = manager.getLocalSLocEntry(i);
    if (!entry.isFile()) continue;
    const std::string path =
        unit.source.file_of(clang::SourceLocation::getFromRawEncoding(entry.getOffset()));
    if (lies_in(path, options.package_dir) && !lies_in(path, options.build_dir))
      unit.facts.units_of_file[path].insert(compiled.file);
  }
}

/// The declarations of the package alone: the parents of system headers are of no interest, and there are
/// many.
void limit_to_package(Unit& unit) {
  std::vector<clang::Decl*> own;
  for (clang::Decl* decl : unit.ast().getTranslationUnitDecl()->decls())
    if (unit.source.in_package(decl->getLocation())) own.push_back(decl);
  unit.ast().setTraversalScope(own);
}

/// Where the unit finds headers, TZC's among them.
std::vector<std::string> include_dirs_of(const CompileUnit& unit, const CollectOptions& options) {
  std::vector<std::string> dirs = options.include_dirs;
  const auto add = [&](const std::string& dir) {
    dirs.push_back(dir[0] == '/' ? dir : unit.directory + "/" + dir);
  };
  for (std::size_t i = 0; i < unit.arguments.size(); ++i) {
    const std::string& argument = unit.arguments[i];
    const bool last = i + 1 == unit.arguments.size();
    if (argument.rfind("-I", 0) == 0 && argument.size() > 2)
      add(argument.substr(2));
    else if (!last && (argument == "-I" || argument == "-isystem" || argument == "-idirafter"))
      add(unit.arguments[i + 1]);
  }
  dirs.insert(dirs.end(), {"/usr/local/include", "/usr/include"});
  return dirs;
}

void note_branches(const ParseResult& parsed, const CollectOptions& options, Facts& facts) {
  for (const SkippedBranch& branch : parsed.skipped)
    if (lies_in(branch.file, options.package_dir) && !lies_in(branch.file, options.build_dir))
      facts.skipped.push_back({branch.file, branch.begin, branch.end, branch.line, 1});
}

}  // namespace

bool has_twin(const Unit& unit, const std::string& message) {
  return std::any_of(unit.include_dirs.begin(), unit.include_dirs.end(), [&](const std::string& dir) {
    return llvm::sys::fs::exists(dir + "/" + twin_header(message));
  });
}

std::vector<Diagnostic> collect_unit(const CompileUnit& unit, const CollectOptions& options, Facts& facts) {
  ParseOptions parse_options;
  parse_options.include_dirs = options.include_dirs;
  parse_options.skip_bodies_outside = options.package_dir;
  const ParseResult parsed = parse(unit, parse_options, [&](clang::ASTContext& ast) {
    if (ast.getDiagnostics().hasErrorOccurred()) return;
    Unit collected{Source(ast, options.package_dir),
                   *options.rules,
                   facts,
                   options.exported_dirs,
                   include_dirs_of(unit, options),
                   {},
                   {},
                   {}};
    note_files(collected, unit, options);
    limit_to_package(collected);
    collect(collected);
    facts.api_calls = api_calls(ast, options.package_dir);
    facts.calls[unit.id()] = package_calls(ast, options.package_dir);
  });
  note_branches(parsed, options, facts);
  return parsed.errors;
}

std::set<std::string> exported_dirs(const std::string& package_dir) {
  std::ifstream file(package_dir + "/CMakeLists.txt");
  std::ostringstream text;
  text << file.rdbuf();
  const std::string content = std::regex_replace(text.str(), std::regex("#[^\n]*"), "");
  std::set<std::string> dirs;
  std::smatch call;
  if (!std::regex_search(content, call, std::regex("catkin_package\\s*\\(([^)]*)\\)"))) return dirs;
  std::istringstream words(call[1].str());
  bool listing = false;
  for (std::string word; words >> word;) {
    if (word == "INCLUDE_DIRS") {
      listing = true;
    } else if (std::regex_match(word, std::regex("[A-Z_]+"))) {
      listing = false;
    } else if (listing) {
      dirs.insert(word[0] == '/' ? word : package_dir + "/" + word);
    }
  }
  return dirs;
}

}  // namespace tzc::rewriter
