// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/file_accesses.h"

namespace tzc::rewriter {

/// A run of the compiler.
struct CompilerReads {
  const std::vector<std::string>& arguments;
  std::string directory;  ///< in which it ran
  std::string scratch;    ///< files below it are the tool's own and not noted
};

/// Notes what a compiler has read, from the make rule that it has written (-MD), and where a header that appears
/// later would be found instead: in every folder of the command, and in /usr/local/include, under every name that
/// the file may have been included by. The compiler's programs are noted as well.
void note_compiler_reads(const std::string& rule, const CompilerReads& reads, FileAccesses& accesses);

/// The prerequisites of a make rule; spaces and dollars in them are escaped as GCC does.
std::vector<std::string> prerequisites_of(const std::string& rule);

/// Absolute path of a program of PATH; as it is when it is not found.
std::string program_path(const std::string& program);

}  // namespace tzc::rewriter
