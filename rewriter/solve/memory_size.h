// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/facts.h"
#include "model/solve_options.h"

namespace tzc::rewriter {

/// The bytes to reserve for a publisher, and a sentence that explains the number.
struct MemorySize {
  std::string text;
  std::string note;
};
MemorySize memory_size(const Advertise& site, const SolveOptions& options);

}  // namespace tzc::rewriter
