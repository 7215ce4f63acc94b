// SPDX-License-Identifier: BSD-3-Clause
#include "tool/progress.h"

#include <unistd.h>

#include <cstdio>

namespace tzc::compare {

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
    std::fprintf(stderr, "\r\033[K%s: %s", part_.c_str(), text.c_str());
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
