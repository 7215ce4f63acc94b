// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// What to do instead of a run: print this and end with that status (--help, --explain, a mistake in the arguments).
struct Answer {
  std::string text;
  int status = 0;
};

}  // namespace tzc::rewriter
