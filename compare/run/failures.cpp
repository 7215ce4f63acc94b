// SPDX-License-Identifier: BSD-3-Clause
#include "run/failures.h"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <fstream>
#include <regex>

#include "pairing/recording.h"

namespace tzc::compare {
namespace {

constexpr std::size_t longest_name = 1000;

/// What stands near the words; "" without them. What a node prints may be of any length, and std::regex recurses for each
/// character.
std::string around(const char* words, const std::string& line) {
  const std::size_t at = line.find(words);
  return at == std::string::npos ? "" : line.substr(at - std::min(at, longest_name), 2 * longest_name);
}

}  // namespace

// What roslaunch says (roslaunch/pmon.py, nodeprocess.py): "[camera-2] process has died [pid 1, exit code 3, ...", behind
// an escape sequence for the colour. Of a required node the name stands in the line before.
std::set<std::string> died_nodes(const std::string& roslaunch_log) {
  static const std::regex name("\\[([^\\[\\]]+)-\\d+\\] (process )?has died");
  static const std::regex death("process has died \\[pid \\d+, exit code (-?\\d+)");
  static const std::regex missing("ERROR: cannot launch node of type \\[([^\\[\\]]+)\\]");
  std::set<std::string> all;
  std::ifstream log(roslaunch_log);
  std::string node;
  for (std::string line; std::getline(log, line);) {
    std::smatch match;
    const std::string end = around("has died", line), start = around("cannot launch node", line);
    if (std::regex_search(end, match, name)) node = without_anonymous_part(match.str(1));
    if (!node.empty() && std::regex_search(end, match, death))
      all.insert(fmt::format("{}: exit code {}", node, match.str(1)));
    if (std::regex_search(start, match, missing)) all.insert(match.str(1) + ": cannot be launched");
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
