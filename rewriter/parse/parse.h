// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/file_accesses.h"
#include "model/location.h"
#include "parse/compile_commands.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

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
  FileAccesses* accesses = nullptr;  ///< told what the parse asks of the disk; may be null
};

/// Parses one unit and calls `then` with its AST. Thread-safe: units can be parsed at the same time.
ParseResult parse(const CompileUnit& unit, const ParseOptions& options,
                  const std::function<void(clang::ASTContext&)>& then);

}  // namespace tzc::rewriter
