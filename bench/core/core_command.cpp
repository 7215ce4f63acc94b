// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <cstdio>
#include <string>
#include <vector>

#include "commands.h"
#include "contenders.h"
#include "options.h"

namespace tzc {
namespace bench {
namespace {

using Contenders = std::vector<std::unique_ptr<Contender>>;

Contenders all_contenders() {
  Contenders contenders;
  contenders.push_back(seqpacket_contender());
  contenders.push_back(tzc_reader_contender());
  contenders.push_back(tzc_own_loop_contender());
#ifdef TZC_BENCH_ICEORYX
  contenders.push_back(iceoryx_listener_contender());
  contenders.push_back(iceoryx_waitset_contender());
#endif
  return contenders;
}

bool wanted(const Options& options, const Contender& contender) {
  return options.only.empty() || std::string(contender.name()).find(options.only) == 0;
}

}  // namespace

int run_core(int argc, char** argv) {
  Options options;
  if (!parse_options(argc, argv, options)) return 2;
  const Contenders contenders = all_contenders();
#ifdef TZC_BENCH_ICEORYX
  const RouDi roudi;
  if (!roudi.running()) std::fprintf(stderr, "iox-roudi does not start: no figures of iceoryx\n");
  const bool iceoryx = roudi.running();
#else
  const bool iceoryx = false;
#endif
  std::vector<Row> rows;
  print_header();
  for (const std::size_t size : options.sizes) {
    for (const std::size_t subscribers : options.subscribers) {
      for (const auto& contender : contenders) {
        const std::string name = "tzcb" + std::to_string(::getpid()) + "-" + std::to_string(rows.size());
        const Setup setup{size, subscribers, options.rate, options.count, name};
        const bool is_iceoryx = std::string(contender->name()).find("iceoryx") == 0;
        if (!wanted(options, *contender) || !contender->supports(setup) || (is_iceoryx && !iceoryx)) continue;
        rows.push_back(measure(*contender, setup));
        print_row(rows.back());
      }
    }
  }
  return options.json.empty() || write_json(options.json, rows) ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
