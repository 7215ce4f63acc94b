// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/edit.h"
#include "model/file_accesses.h"
#include "parse/compile_commands.h"
#include "parse/diagnostic.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

/// A preprocessor branch that this unit does not compile, from its directive to one whose branch it compiles, or #endif.
struct SkippedBranch {
  std::string file;
  unsigned line = 0;
  unsigned begin = 0, end = 0;
};

/// File and line of an #if, #elif or #else.
using BranchDirective = std::pair<std::string, unsigned>;

struct ParseResult {
  std::vector<Diagnostic> errors;
  bool crashed = false;  ///< on this unit, which is a defect of ours or of Clang; errors says so
  std::vector<SkippedBranch> skipped;  ///< once for each time that the unit reads the file
  std::set<BranchDirective> compiled;  ///< of the branches that it compiles, one of the times at least
};

struct ParseOptions {
  FileContents overlay;                   ///< path -> content that stands for the file's own
  std::vector<std::string> include_dirs;  ///< searched last
  bool skip_system_bodies = false;        ///< function bodies of system headers are not parsed
  FileAccesses* accesses = nullptr;       ///< told what the parse asks of the disk; may be null
};

/// Parses one unit and calls `then` with its AST, on another thread; not where it does not parse. Thread-safe: units can be parsed
/// at the same time. Where Clang or `then` crashes, that is the only error, and what `then` had begun may not be used.
ParseResult parse(const CompileUnit& unit, const ParseOptions& options,
                  const std::function<void(clang::ASTContext&)>& then);

}  // namespace tzc::rewriter
