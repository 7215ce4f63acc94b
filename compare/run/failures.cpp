// SPDX-License-Identifier: BSD-3-Clause
#include "run/failures.h"

#include <fmt/format.h>
#include <signal.h>

#include <fstream>
#include <regex>

namespace tzc::compare {

std::set<std::string> died_nodes(const std::string& roslaunch_log) {
  static const std::regex death("\\[([^\\]]+)-\\d+\\] process has died \\[pid \\d+, exit code (-?\\d+)");
  std::set<std::string> all;
  std::ifstream log(roslaunch_log);
  for (std::string line; std::getline(log, line);) {
    std::smatch match;
    if (std::regex_search(line, match, death))
      all.insert(fmt::format("{}: exit code {}", match.str(1), match.str(2)));
  }
  return all;
}

std::string bad_end(const std::string& command, int status, bool was_stopped) {
  const int signal = status - 128;
  const bool is_crash =
      signal == SIGSEGV || signal == SIGABRT || signal == SIGBUS || signal == SIGILL || signal == SIGFPE;
  if (status == 0 || (was_stopped && !is_crash)) return "";
  return is_crash ? fmt::format("{}: signal {}", command, signal)
                  : fmt::format("{}: exit code {}", command, status);
}

}  // namespace tzc::compare
