// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "buildfiles/compile_database.h"
#include "model/compiler_error.h"
#include "model/file_accesses.h"
#include "proof/scratch_folder.h"
#include "proof/scratch_workspace.h"

namespace tzc::rewriter {

/// The options of the checks with the package's own compiler.
struct OwnCompilerSetup {
  std::vector<std::string> packages;      ///< canonical folders
  std::string root;                       ///< the folder of the workspace's packages, as the build names it
  std::vector<std::string> build_dirs;    ///< each holds a compile_commands.json
  std::vector<std::string> include_dirs;  ///< TZC's headers, as system headers
  std::vector<std::string> defines;       ///< "TZC_ENABLED"
  unsigned jobs = 0;                      ///< 0: one for each processor
  FileAccesses* accesses = nullptr;       ///< told what the compiler reads; may be null
  /// Called for each unit that it has read, one at a time.
  std::function<void(unsigned done, unsigned total, const std::string& unit)> progress = {};
};

/// The errors that a command's unit has as C++14 and has not with the command's own, older standard.
std::vector<CompilerError> errors_of_cxx14(const CompileCommand& command);

/// The compiler of compile_commands.json on a scratch copy of the packages: -fsyntax-only, with every flag that
/// the build gives it. The first check makes the copy.
class OwnCompiler {
 public:
  explicit OwnCompiler(OwnCompilerSetup setup) : setup_(std::move(setup)) {}

  /// CompilerCheck.
  Expected<std::vector<CompilerError>> check(const FileContents& contents,
                                             const std::set<std::string>& units);

  /// The errors of a unit as the user has it; empty: it compiles. Needs no scratch copy.
  Expected<std::vector<CompilerError>> errors_of_original(const std::string& unit);

 private:
  struct Task {
    std::string unit;
    const CompileCommand* command = nullptr;
    std::vector<std::string> arguments;  ///< on the scratch copy
    std::vector<CompilerError> errors;
    std::string reads;  ///< where the compiler lists what it reads; empty: not needed
  };
  Expected<void> read_commands();
  Expected<void> make_copy();
  std::vector<Task> tasks_for(const std::set<std::string>& units) const;
  void record_reads(std::vector<Task>& tasks) const;
  void note_reads(const Task& task) const;
  std::vector<CompilerError> ported_errors(const Task& task) const;
  std::vector<CompilerError> original_errors(const CompileCommand& command) const;
  std::vector<std::string> prefix_maps() const;
  std::vector<std::string> ported_command(const CompileCommand& command) const;
  std::string scratch_word(const std::string& word, const std::string& directory) const;
  std::string scratch_source(const std::string& file) const;
  std::string scratch_included(const std::string& name, const std::string& directory) const;
  bool is_built(const std::string& file) const;

  OwnCompilerSetup setup_;
  std::vector<CompileCommand> commands_;
  std::unique_ptr<ScratchFolder> folder_;
  std::unique_ptr<ScratchWorkspace> copy_;
};

}  // namespace tzc::rewriter
