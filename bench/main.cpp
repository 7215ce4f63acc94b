// SPDX-License-Identifier: BSD-3-Clause
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <system_error>

#include "commands.h"

namespace {

using tzc::bench::Command;

const Command commands[] = {
    {"core", "one-way latency of the core next to a bare socket and iceoryx", tzc::bench::run_core},
#ifdef TZC_BENCH_ROSCPP
    {"roscpp", "one-way latency between ROS nodes: TCPROS, TZC, intraprocess, next to a bare socket",
     tzc::bench::run_roscpp},
    {"scale", "many topics between few processes: threads, descriptors, memory, time until all are shared",
     tzc::bench::run_scale},
    {"soak", "nodes that are killed, stopped and replaced, for hours: messages, memory, descriptors, threads",
     tzc::bench::run_soak},
#endif
#ifdef TZC_BENCH_PAPER
    {"paper", "the evaluation of the TZC paper: latency, reliability, copies; tables, plots, a page",
     tzc::bench::run_paper},
#endif
    {"sustained", "1 publisher, 8 subscribers, 4 MB at 200 Hz: losses and memory", tzc::bench::run_sustained},
#ifdef TZC_BENCH_INSIDE
    {"inside", "what allocate and publish cost by themselves (Google Benchmark's options)",
     tzc::bench::run_inside},
#endif
};

/// The table is the result: a full disk, or a closed pipe, is a failure.
int unless_unwritable(int status) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  std::fprintf(stderr, "tzc-bench: cannot write to standard output: %s\n", std::strerror(errno));
  return status == 0 ? 1 : status;
}

/// Where the system starts no more processes, what the command had begun is gone with its frames.
int run(const Command& command, int argc, char** argv) {
  try {
    return command.run(argc, argv);
  } catch (const std::system_error& error) {
    std::fprintf(stderr, "tzc-bench %s: %s\n", command.name, error.what());
    return 1;
  }
}

int usage(std::FILE* to, int status) {
  std::fputs("Usage: tzc-bench COMMAND [OPTIONS]\n\nCommands:\n", to);
  for (const Command& command : commands) std::fprintf(to, "  %-10s %s\n", command.name, command.help);
  std::fputs(
      "\ntzc-bench COMMAND --help tells its options. Each but paper prints a table and takes --json FILE.\n\n"
      "Examples:\n  tzc-bench core --json core.json\n  tzc-bench roscpp --sizes 4m --subscribers 8\n"
      "  tzc-bench paper --quick --output figures\n",
      to);
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  for (const Command& command : commands) {
    if (name == command.name) return unless_unwritable(run(command, argc - 1, argv + 1));
  }
  const bool asked = name == "--help" || name == "-h";
  if (!asked && !name.empty()) std::fprintf(stderr, "tzc-bench: no command %s\n", name.c_str());
  return asked ? unless_unwritable(usage(stdout, 0)) : usage(stderr, 2);
}
