// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::rewriter {

struct ProcessResult {
  int status = -1;  ///< exit status; -1: could not be started or was killed
  std::string output;
  std::string errors;
};

/// Runs a program found on the PATH, without a shell, and waits for it.
ProcessResult run_process(const std::vector<std::string>& arguments);

}  // namespace tzc::rewriter
