// SPDX-License-Identifier: BSD-3-Clause
#include "tool/progress.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>

namespace tzc::compare {

namespace {

/// One less than the terminal has, so that the line does not go on in the next one.
std::size_t columns() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1U : 79U;
}

}  // namespace

ProgressLine::ProgressLine(bool is_quiet) : is_quiet_(is_quiet), is_terminal_(::isatty(STDERR_FILENO) != 0) {}

ProgressLine::~ProgressLine() {
  end();
}

void ProgressLine::begin_part(const std::string& part) {
  part_ = part;
  step_.clear();
}

void ProgressLine::show(const std::string& text) {
  if (is_quiet_) return;
  if (is_terminal_) {
    const std::string line = part_ + ": " + text;
    std::fprintf(stderr, "\r\033[K%s", line.substr(0, columns()).c_str());
    std::fflush(stderr);
    return;
  }
  const std::string step = text.substr(0, text.find_first_of(":,"));
  if (step != step_) std::fprintf(stderr, "%s: %s\n", part_.c_str(), step.c_str());
  step_ = step;
}

void ProgressLine::end() {
  if (!is_quiet_ && is_terminal_) std::fputs("\r\033[K", stderr);
}

}  // namespace tzc::compare
