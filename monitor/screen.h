// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>

#include <string>

namespace tzc::monitor {

/// The terminal while tzc-monitor refreshes it: its second screen, without cursor. The first screen comes back at the
/// end, which Ctrl-C and the other signals that end a program only ask for, and while Ctrl-Z stops it. A job in the background
/// stops until the shell's `fg`.
class Screen {
 public:
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  /// Replaces what is shown; what does not fit below is cut, with a line that says so.
  void show(const std::string& text);
  /// False: a signal has asked for the end.
  bool wait(double seconds);

 private:
  void enter();
  void leave();

  sigset_t awaited_, before_;
  bool is_shown_ = false;
};

/// The lines of a text that fit into a terminal, each followed by what clears the rest of its line. A line of words (a
/// problem, a connection) goes on in the next one, a row of the table is cut. Colours stay.
std::string fitted(const std::string& text, std::size_t rows, std::size_t columns);

}  // namespace tzc::monitor
