// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tzc::rewriter {

struct ProcessResult {
  int status = -1;  ///< exit status; -1: could not be started or was killed
  std::string output;
  std::string errors;
};

struct Command {
  std::vector<std::string> arguments;              ///< the program first, found on the PATH
  std::string folder;                              ///< working folder; empty: this process's own
  std::map<std::string, std::string> environment;  ///< on top of this process's own
};

/// Runs a program without a shell and waits for it. Its standard input is empty. Thread-safe.
ProcessResult run_process(const Command& command);
ProcessResult run_process(const std::vector<std::string>& arguments);

}  // namespace tzc::rewriter
