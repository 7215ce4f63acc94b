// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::rewriter {

/// Receives the progress of a long run; called from any thread of the engine, one at a time.
class Progress {
 public:
  virtual ~Progress() = default;
  /// `stage` as in "parsing", "verifying"; `done` of `total` units finished, `what` the one that just was.
  virtual void step(const std::string& stage, unsigned done, unsigned total, const std::string& what) = 0;
};

}  // namespace tzc::rewriter
