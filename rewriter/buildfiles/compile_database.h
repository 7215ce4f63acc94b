// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

/// One entry of a compile_commands.json.
struct CompileCommand {
  std::string directory;
  std::string file;       ///< absolute, as the build names it
  std::string canonical;  ///< the same file without symbolic links
  std::vector<std::string>
      arguments;  ///< the compiler, or its launcher, first; with the words of response files
  std::vector<std::string> response_files;
  std::string target;      ///< of CMake; empty: unknown
  std::string target_dir;  ///< where CMake builds the target; empty: unknown
};

/// All entries of a build folder's compile_commands.json. An error when it cannot be read.
Expected<std::vector<CompileCommand>> read_compile_commands(const std::string& build_dir);

/// A command's words without what it writes (-o, -c, -MD, ...).
std::vector<std::string> without_outputs(const std::vector<std::string>& arguments);

/// The targets that compile each file, by canonical path.
Expected<std::map<std::string, std::set<std::string>>> targets_of_files(const std::string& build_dir);

/// Canonical paths of the files that are compiled.
Expected<std::set<std::string>> compiled_files(const std::string& build_dir);

/// The sources that a file of a unity build includes, canonical; empty: it is no such file.
std::vector<std::string> unity_sources(const std::string& file);

/// Words of a shell command: quotes and backslashes as a POSIX shell reads them, nothing expanded.
std::vector<std::string> shell_words(const std::string& command);

}  // namespace tzc::rewriter
