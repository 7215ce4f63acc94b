// SPDX-License-Identifier: BSD-3-Clause
#include "tool/terminal.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

namespace tzc::rewriter {
namespace {

std::size_t columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

bool is_dumb() {
  const char* terminal = std::getenv("TERM");
  return !terminal || std::string(terminal) == "dumb";
}

double processor_seconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

rusage used_by(int whose) {
  rusage usage{};
  ::getrusage(whose, &usage);
  return usage;
}

}  // namespace

void say(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

bool wants_colour(int descriptor) {
  const char* refused = std::getenv("NO_COLOR");
  return isatty(descriptor) && !(refused && *refused) && !is_dumb();
}

TerminalProgress::TerminalProgress(bool enabled)
    : enabled_(enabled), terminal_(isatty(STDERR_FILENO) && !is_dumb()) {}

TerminalProgress::~TerminalProgress() {
  clear();
}

void TerminalProgress::step(const std::string& stage, unsigned done, unsigned total,
                            const std::string& what) {
  if (!enabled_) return;
  std::string line = fmt::format("{} {}/{} {}", stage, done, total, what);
  if (!terminal_) return log(stage, line, done >= total);
  if (line.size() >= columns()) line.resize(columns() - 1);
  rewriter::say("\r\033[K" + line);
  shown_ = true;
}

void TerminalProgress::log(const std::string& stage, const std::string& line, bool last) {
  constexpr std::chrono::seconds interval{10};
  const auto now = std::chrono::steady_clock::now();
  if (stage == stage_ && !last && now - logged_ < interval) return;
  rewriter::say("tzc-rewrite: " + line + "\n");
  stage_ = last ? "" : stage;
  logged_ = now;
}

void TerminalProgress::say(const std::string& line) {
  clear();
  if (!enabled_) return;
  rewriter::say("tzc-rewrite: " + line + "\n");
}

void TerminalProgress::end() {
  clear();
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun_;
  if (!enabled_) return;
  const rusage own = used_by(RUSAGE_SELF), others = used_by(RUSAGE_CHILDREN);
  rewriter::say(fmt::format(
      "tzc-rewrite: {:.1f} s; processor time: {:.1f} s for tzc-rewrite, {:.1f} s for compilers and CMake; "
      "memory: {} MB, {} MB for the largest of those\n",
      taken.count(), processor_seconds(own), processor_seconds(others), own.ru_maxrss / 1024,
      others.ru_maxrss / 1024));
}

void TerminalProgress::clear() {
  if (!shown_) return;
  rewriter::say("\r\033[K");
  shown_ = false;
}

}  // namespace tzc::rewriter
