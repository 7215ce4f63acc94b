// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>

#include "commands.h"
#include "core/contenders.h"
#include "options.h"
#include "processes.h"
#include "roscpp/contenders.h"
#include "roscpp/roscore.h"
#include "sweep.h"

namespace tzc {
namespace bench {

int run_roscpp(int argc, char** argv) {
  Options options;
  options.sizes = {4096, 4 << 20};
  options.rate = 30;
  const auto over =
      parse_options(argc, argv, "One-way latency between ROS nodes, next to a bare socket.", options);
  if (over) return *over;
  hold_interrupts();
  const RosCore core;
  if (!core.running()) {
    std::fprintf(stderr, "rosmaster does not start: is ROS's environment set up (source setup.bash)?\n");
    return 1;
  }
  Contenders contenders;
  contenders.push_back(seqpacket_contender());
  contenders.push_back(tzc_direct_contender());
  contenders.push_back(tzc_spin_contender());
  contenders.push_back(tzc_queue_contender());
  contenders.push_back(tzc_attached_contender());
  contenders.push_back(intraprocess_contender());
  contenders.push_back(tcpros_contender());
  return sweep(options, contenders);
}

}  // namespace bench
}  // namespace tzc
