// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.h"

#include <unistd.h>

#include <string>

namespace tzc {
namespace bench {
namespace {

bool wanted(const Options& options, const Contender& contender) {
  return options.only.empty() || std::string(contender.name()).find(options.only) == 0;
}

}  // namespace

int sweep(const Options& options, const std::vector<std::unique_ptr<Contender>>& contenders) {
  std::vector<Row> rows;
  print_header();
  for (const std::size_t size : options.sizes) {
    for (const std::size_t subscribers : options.subscribers) {
      for (const auto& contender : contenders) {
        const std::string name = "tzcb" + std::to_string(::getpid()) + "-" + std::to_string(rows.size());
        const Setup setup{size, subscribers, options.rate, options.count, name};
        if (!wanted(options, *contender) || !contender->supports(setup)) continue;
        rows.push_back(measure(*contender, setup));
        print_row(rows.back());
      }
    }
  }
  return options.json.empty() || write_json(options.json, rows) ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
