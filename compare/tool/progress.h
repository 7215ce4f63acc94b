// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace tzc::compare {

/// Shows the progress on standard error: on a terminal one line that changes, otherwise a line for each step.
class ProgressLine {
 public:
  explicit ProgressLine(bool is_quiet);
  ~ProgressLine();
  /// "[1/3] original"; from now on it precedes the text.
  void begin_part(const std::string& part);
  /// @param text what comes before a colon or comma is the step's name
  void show(const std::string& text);
  /// Clears the line.
  void end();

 private:
  const bool is_quiet_, is_terminal_;
  std::string part_, step_;
};

}  // namespace tzc::compare
