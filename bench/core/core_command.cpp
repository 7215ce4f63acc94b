// SPDX-License-Identifier: BSD-3-Clause
#include <cstdio>
#include <vector>

#include "commands.h"
#include "contenders.h"
#include "options.h"
#include "sweep.h"

namespace tzc {
namespace bench {
namespace {

Contenders all_contenders(bool iceoryx) {
  Contenders contenders;
  contenders.push_back(seqpacket_contender());
  contenders.push_back(futex_contender());
  contenders.push_back(tzc_reader_contender());
  contenders.push_back(tzc_own_loop_contender());
#ifdef TZC_BENCH_ICEORYX
  if (iceoryx) {
    contenders.push_back(iceoryx_listener_contender());
    contenders.push_back(iceoryx_waitset_contender());
  }
#else
  (void)iceoryx;
#endif
  return contenders;
}

}  // namespace

int run_core(int argc, char** argv) {
  Options options;
  const auto over =
      parse_options(argc, argv, "One-way latency of TZC's core next to a bare socket and iceoryx.", options);
  if (over) return *over;
#ifdef TZC_BENCH_ICEORYX
  const RouDi roudi;
  if (!roudi.running()) std::fprintf(stderr, "iox-roudi does not start: no figures of iceoryx\n");
  const bool iceoryx = roudi.running();
#else
  const bool iceoryx = false;
#endif
  return sweep(options, all_contenders(iceoryx));
}

}  // namespace bench
}  // namespace tzc
