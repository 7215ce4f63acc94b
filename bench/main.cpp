// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <cstring>

#include "commands.h"

namespace {

using tzc::bench::Command;

const Command commands[] = {
    {"core", "one-way latency of the core next to a bare socket and iceoryx", tzc::bench::run_core},
#ifdef TZC_BENCH_ROSCPP
    {"roscpp", "one-way latency between ROS nodes: TCPROS, TZC, intraprocess, next to a bare socket",
     tzc::bench::run_roscpp},
#endif
    {"sustained", "1 publisher, 8 subscribers, 4 MB at 200 Hz: losses and memory", tzc::bench::run_sustained},
#ifdef TZC_BENCH_INSIDE
    {"inside", "what allocate and publish cost by themselves (Google Benchmark's options)",
     tzc::bench::run_inside},
#endif
};

int usage() {
  std::fprintf(stderr, "usage: tzc-bench COMMAND [options]\n");
  for (const Command& command : commands) std::fprintf(stderr, "  %-10s %s\n", command.name, command.help);
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  for (const Command& command : commands) {
    if (argc > 1 && std::strcmp(argv[1], command.name) == 0) return command.run(argc - 1, argv + 1);
  }
  return usage();
}
