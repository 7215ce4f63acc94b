// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "port/port_inputs.h"
#include "tool/parse_options.h"

namespace tzc::rewriter {

/// A whole run of tzc-rewrite on checked options; writes to standard output and error. Returns the exit
/// status.
int run(const Options& options, const Engine& engine);

/// The program: arguments to exit status.
int tool_main(int argc, const char* const* argv, const Engine& engine);

}  // namespace tzc::rewriter
