// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "commands.h"
#include "contenders.h"
#include "options.h"
#include "processes.h"
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

#ifdef TZC_BENCH_ICEORYX
bool wants_iceoryx(const Options& options) {
  return options.only.empty() ||
         std::any_of(options.only.begin(), options.only.end(),
                     [](const std::string& name) { return name.rfind("iceoryx", 0) == 0; });
}
#endif

}  // namespace

int run_core(int argc, char** argv) {
  Options options;
  const auto over =
      parse_options(argc, argv, "One-way latency of TZC's core next to a bare socket and iceoryx.", options);
  if (over) return *over;
  hold_interrupts();
#ifdef TZC_BENCH_ICEORYX
  std::optional<RouDi> roudi;
  if (wants_iceoryx(options)) roudi.emplace();
  const bool iceoryx = !roudi || roudi->running();
  if (!iceoryx) std::fprintf(stderr, "iox-roudi does not start: no figures of iceoryx\n");
#else
  const bool iceoryx = false;
#endif
  return sweep(options, all_contenders(iceoryx));
}

}  // namespace bench
}  // namespace tzc
