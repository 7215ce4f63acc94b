// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "edits/edit.h"
#include "report/model.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

/// How one translation unit is compiled.
struct CompileUnit {
  std::string file;  ///< absolute, canonical
  std::string directory;
  std::vector<std::string> arguments;

  /// Tells it from the same file compiled for another target.
  std::string id() const {
    std::string text = file;
    for (const std::string& argument : arguments) text += "\n" + argument;
    return text;
  }
};

/// The units of a package in a build folder's compile_commands.json. An error when there are none.
Expected<std::vector<CompileUnit>> load_units(const std::string& package_dir, const std::string& build_dir);

struct Diagnostic {
  Location where;
  std::string text;
  std::vector<Location> notes;  ///< "in instantiation of ...": places that led there
};

/// A preprocessor branch that this unit does not compile.
struct SkippedBranch {
  std::string file;
  unsigned line = 0;
  unsigned begin = 0, end = 0;
};

struct ParseResult {
  std::vector<Diagnostic> errors;
  std::vector<SkippedBranch> skipped;
};

struct ParseOptions {
  FileContents overlay;                   ///< path -> content that stands for the file's own
  std::vector<std::string> include_dirs;  ///< searched last
  std::string skip_bodies_outside;  ///< function bodies outside this folder are not parsed; empty: all are
  bool all_errors = false;
};

/// Parses one unit and hands its AST to `then`. Thread-safe: units can be parsed at the same time.
ParseResult parse(const CompileUnit& unit, const ParseOptions& options,
                  const std::function<void(clang::ASTContext&)>& then);

/// Calls work(0) ... work(count - 1) on `jobs` threads (0: one per processor).
void in_parallel(unsigned jobs, std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace tzc::rewriter
