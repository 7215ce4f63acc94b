// SPDX-License-Identifier: BSD-3-Clause
#include "screen.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <sstream>
#include <vector>

namespace tzc::monitor {
namespace {

void write_all(const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t size = ::write(STDOUT_FILENO, text.data() + done, text.size() - done);
    if (size <= 0 && errno != EINTR) return;
    if (size > 0) done += static_cast<std::size_t>(size);
  }
}

constexpr char second_screen[] = "\x1b[?1049h\x1b[?25l", first_screen[] = "\x1b[?25h\x1b[?1049l";

/// The terminal is somebody else's now, as after the shell's `bg`.
bool is_in_background() {
  const pid_t foreground = ::tcgetpgrp(STDOUT_FILENO);
  return foreground > 0 && foreground != ::getpgrp();
}

/// A signal that ends the program waits until it is taken.
bool is_end_asked_for() {
  sigset_t pending;
  if (::sigpending(&pending) != 0) return false;
  const auto ends = {SIGINT, SIGTERM, SIGHUP, SIGQUIT};
  return std::any_of(ends.begin(), ends.end(),
                     [&](int signal) { return ::sigismember(&pending, signal) == 1; });
}

/// The first `columns` characters; escape sequences take no room.
std::string cut(const std::string& line, std::size_t columns) {
  std::string kept;
  bool is_escape = false;
  std::size_t width = 0;
  for (const char c : line) {
    if (c == '\x1b') is_escape = true;
    if (is_escape || width++ < columns) kept += c;
    if (is_escape && c == 'm') is_escape = false;
  }
  return kept;
}

std::size_t width(const std::string& text) {
  std::size_t columns = 0;
  bool is_escape = false;
  for (const char c : text) {
    if (c == '\x1b') is_escape = true;
    if (!is_escape) ++columns;
    if (is_escape && c == 'm') is_escape = false;
  }
  return columns;
}

/// Problems and connections are words; topics are rows of numbers, whose last column matters least.
bool is_of_words(const std::string& line) {
  return line.rfind("    -> ", 0) == 0 || line.rfind("    <- ", 0) == 0 ||
         line.find(". ") != std::string::npos || (!line.empty() && line.back() == '.');
}

/// Lines of at most so many columns, broken between words; what stands in columns stays there.
void wrap(const std::string& line, std::size_t columns, std::vector<std::string>& lines) {
  const std::string indent(columns > 40 ? 11 : 2, ' ');
  std::string current;
  for (std::size_t at = 0, word = 0; (word = line.find_first_not_of(' ', at)) != std::string::npos;) {
    const std::size_t end = std::min(line.find(' ', word), line.size());
    std::string more = line.substr(at, end - at);
    if (!current.empty() && width(current) + width(more) > columns) {
      lines.push_back(cut(current, columns));
      current.clear();
      more = indent + line.substr(word, end - word);
    }
    current += more;
    at = end;
  }
  lines.push_back(cut(current, columns));
}

}  // namespace

std::string fitted(const std::string& text, std::size_t rows, std::size_t columns) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    if (width(line) > columns && is_of_words(line))
      wrap(line, columns, lines);
    else
      lines.push_back(cut(line, columns));
  }
  if (lines.size() > rows && rows > 0) {
    const std::size_t hidden = lines.size() - rows + 1;
    lines.resize(rows - 1);
    lines.push_back(cut(fmt::format("... {} more lines: see --topic and --once", hidden), columns));
  }
  std::string result;
  for (const std::string& line : lines) result += (result.empty() ? "" : "\r\n") + line + "\x1b[K";
  return result;
}

// Signals wait for wait(), so none can leave the terminal as it is.
Screen::Screen() {
  ::sigemptyset(&awaited_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP}) ::sigaddset(&awaited_, signal);
  ::sigprocmask(SIG_BLOCK, &awaited_, &before_);
  enter();
}

Screen::~Screen() {
  leave();
  ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

void Screen::show(const std::string& text) {
  if (!is_shown_) return;
  winsize size{};
  if (::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_row == 0) size.ws_row = 24;
  if (size.ws_col == 0) size.ws_col = 80;
  write_all("\x1b[H" + fitted(text, size.ws_row, size.ws_col) + "\x1b[J");
}

bool Screen::wait(double seconds) {
  timespec pause{};
  pause.tv_sec = static_cast<time_t>(seconds);
  pause.tv_nsec = static_cast<long>((seconds - std::floor(seconds)) * 1e9);
  const int signal = ::sigtimedwait(&awaited_, nullptr, &pause);
  if (signal != SIGTSTP) return signal < 0;
  leave();
  ::raise(SIGSTOP);
  enter();
  return true;
}

void Screen::enter() {
  while (is_in_background() && !is_end_asked_for()) ::raise(SIGSTOP);
  is_shown_ = !is_in_background();
  if (is_shown_) write_all(second_screen);
}

void Screen::leave() {
  if (is_shown_) write_all(first_screen);
  is_shown_ = false;
}

}  // namespace tzc::monitor
