// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "model/progress.h"

namespace tzc::rewriter {

/// Whether a stream's descriptor is a terminal that wants colours (NO_COLOR and TERM=dumb are respected).
bool wants_colour(int descriptor);

/// Writes to standard error. That nobody reads it any more is no reason to stop.
void say(const std::string& text);

/// One line on standard error that is overwritten as the work goes on. Where that is no terminal, a line for
/// each stage that begins or ends, and one every ten seconds between.
class TerminalProgress : public Progress {
 public:
  explicit TerminalProgress(bool enabled);
  ~TerminalProgress() override;
  void step(const std::string& stage, unsigned done, unsigned total, const std::string& what) override;
  /// A line that stays.
  void say(const std::string& line);
  void clear();
  /// Clears the line and says what the work took: time, and of the processor's time and of memory what the programs took
  /// that it has started.
  void end();

 private:
  void log(const std::string& stage, const std::string& line, bool last);

  bool enabled_, terminal_;
  bool shown_ = false;
  std::string stage_;  ///< of the last line in a log
  std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now(), logged_;
};

}  // namespace tzc::rewriter
