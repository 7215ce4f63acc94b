// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc {
namespace bench {

/// How a program ended, and what it wrote.
struct ProgramResult {
  int status =
      127;  // as in a shell: 127 where there is none of this name, or none starts; negative: ended by this signal
  std::string output;
  std::string error;
};

/// Runs a program of TZC until it ends: the one beside this program, else the one on the PATH. command[0] is its name.
ProgramResult run_program(const std::vector<std::string>& command);

}  // namespace bench
}  // namespace tzc
