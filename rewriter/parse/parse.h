// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/edit.h"
#include "model/file_accesses.h"
#include "parse/compile_commands.h"
#include "parse/diagnostic.h"
#include "parse/preprocessor_notes.h"

namespace clang {
class ASTContext;
}

namespace tzc::rewriter {

struct ParseResult {
  std::vector<Diagnostic> errors;
  bool crashed = false;            ///< on this unit, which is a defect of ours or of Clang; errors says so
  PreprocessorNotes preprocessor;  ///< outside of system headers
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
