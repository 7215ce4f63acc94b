// SPDX-License-Identifier: BSD-3-Clause
/// tzc-monitor: what the nodes of this machine do with TZC.
///
///   /proc/PID/fd -> take_sample (read_page) -> keep_topic, add_rates -> table, json_report, explain
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>
#include <thread>

#include "filter.h"
#include "join_trace.h"
#include "json_report.h"
#include "options.h"
#include "processes.h"
#include "rates.h"
#include "screen.h"
#include "table.h"
#include "why.h"

namespace tzc::monitor {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int found = 0, nothing_found = 1, wrong_usage = 2;

const char* const nobody =
    "tzc-monitor: no process of this user uses TZC. A node has a statistics page from its first subscriber, "
    "or "
    "from its first publisher that offers shared memory, on, unless ~tzc/statistics_page or ~tzc/disable say "
    "otherwise.\n";

/// A terminal that knows more than lines.
bool is_screen() {
  const char* const terminal = std::getenv("TERM");
  return ::isatty(STDOUT_FILENO) == 1 && terminal && *terminal && std::strcmp(terminal, "dumb") != 0;
}

bool wants_colours() {
  const char* const refused = std::getenv("NO_COLOR");
  return is_screen() && (!refused || !*refused);
}

void report(const Sample& sample) {
  for (const std::string& trouble : sample.troubles) fmt::print(stderr, "tzc-monitor: {}\n", trouble);
}

/// Each node that runs has updated its page since, so that it has rates.
bool has_moved_on(const std::vector<Node>& before, const std::vector<Node>& now) {
  return std::all_of(now.begin(), now.end(), [&](const Node& node) {
    return node.state != State::running || std::none_of(before.begin(), before.end(), [&](const Node& other) {
             return other.pid == node.pid && other.updated_ns == node.updated_ns;
           });
  });
}

Sample sample_with_rates(double interval_s) {
  const Sample before = take_sample();
  if (interval_s <= 0 || before.nodes.empty()) return before;
  const auto pause = std::chrono::duration<double>(interval_s);
  const auto end = Clock::now() + pause + std::chrono::seconds(1);
  std::this_thread::sleep_for(pause);
  Sample now = take_sample();
  while (!has_moved_on(before.nodes, now.nodes) && Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    now = take_sample();
  }
  add_rates(before.nodes, now.nodes);
  return now;
}

int explain_why(const Options& options) {
  const Sample sample = take_sample();
  report(sample);
  const Explanation explanation = explain(sample.nodes, options.why[0], options.why[1]);
  for (const std::string& sentence : explanation.sentences) fmt::print("{}\n", sentence);
  if (explanation.sentences.empty()) fmt::print(stderr, "tzc-monitor: {}\n", explanation.nothing);
  return explanation.sentences.empty() ? nothing_found : found;
}

/// The file that standard output goes to, as in `--join-trace t.json.* >t.json.all`: what is read of it would be written
/// to it, without an end.
bool is_output(const std::string& name) {
  struct stat output{}, input{};
  return ::fstat(STDOUT_FILENO, &output) == 0 && S_ISREG(output.st_mode) &&
         ::stat(name.c_str(), &input) == 0 && input.st_dev == output.st_dev && input.st_ino == output.st_ino;
}

int join_traces(const Options& options) {
  const auto own = std::find_if(options.traces.begin(), options.traces.end(), is_output);
  if (own != options.traces.end()) {
    fmt::print(stderr, "tzc-monitor: {} is the output, too: name another file for it\n", *own);
    return wrong_usage;
  }
  TraceJoin join(std::cout);
  bool is_readable = true;
  for (const std::string& name : options.traces) {
    std::ifstream file(name);
    if (file) {
      is_readable = join.add(file, name) && is_readable;
      continue;
    }
    fmt::print(stderr, "tzc-monitor: cannot read {}: {}\n", name, std::strerror(errno));
    is_readable = false;
  }
  const bool has_events = join.finish();
  for (const std::string& trouble : join.troubles()) fmt::print(stderr, "tzc-monitor: {}\n", trouble);
  if (!is_readable) return wrong_usage;
  return has_events ? found : nothing_found;
}

int print_once(const Options& options) {
  Sample sample = sample_with_rates(options.interval_s);
  report(sample);
  const bool has_nodes = !sample.nodes.empty();
  keep_topic(options.topic, sample.nodes);
  if (options.json)
    fmt::print("{}", json_report(sample.nodes));
  else if (!sample.nodes.empty())
    fmt::print("{}", table(sample.nodes, wants_colours()));
  if (!sample.nodes.empty()) return found;
  if (!has_nodes)
    fmt::print(stderr, "{}", nobody);
  else
    fmt::print(stderr, "tzc-monitor: no process of this user publishes or receives {} with TZC\n",
               global_name(options.topic));
  return nothing_found;
}

int refresh(const Options& options) {
  const bool has_colours = wants_colours();
  std::vector<Node> before;
  Screen screen;
  do {
    Sample sample = take_sample();
    add_rates(before, sample.nodes);
    before = sample.nodes;
    keep_topic(options.topic, sample.nodes);
    std::string text = table(sample.nodes, has_colours);
    if (sample.nodes.empty()) text += "nothing to show yet\n";
    for (const std::string& trouble : sample.troubles) text += trouble + "\n";
    screen.show(text);
  } while (screen.wait(options.interval_s));
  return found;
}

int run(const Options& options) {
  if (!options.traces.empty()) return join_traces(options);
  if (!options.why.empty()) return explain_why(options);
  const bool is_live = !options.once && !options.json && is_screen();
  return is_live ? refresh(options) : print_once(options);
}

}  // namespace
}  // namespace tzc::monitor

int main(int argc, char** argv) {
  int status = 0;
  try {
    const auto options = tzc::monitor::parse_options(argc, argv, status);
    if (options) status = tzc::monitor::run(*options);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    std::fprintf(stderr, "tzc-monitor: cannot write to standard output: %s\n", std::strerror(errno));
    return tzc::monitor::wrong_usage;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tzc-monitor: %s\n", error.what());
    return tzc::monitor::wrong_usage;
  }
}
