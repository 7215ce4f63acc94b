// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace tzc {
namespace bench {
namespace {

/// One line of the table while its samples come in.
struct Entry {
  Contender* contender;
  Setup setup;
  Samples samples{};
};

bool wanted(const Options& options, const Contender& contender, const Setup& setup) {
  const auto& only = options.only;
  const bool named = only.empty() || std::find(only.begin(), only.end(), contender.name()) != only.end();
  return named && contender.supports(setup);
}

void measure_share(const Options& options, std::size_t round, Entry& entry) {
  Setup share = entry.setup;
  share.count = share_of(options, round);
  share.name = unique_name();
  if (share.count > 0) add(measure(*entry.contender, share), entry.samples);
}

void show_progress(std::size_t done, std::size_t of) {
  if (::isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, done == of ? "\r\033[K" : "\rmeasured %zu of %zu", done, of);
}

}  // namespace

std::vector<std::pair<Contender*, Setup>> wanted_cells(const Options& options, const Contenders& contenders) {
  std::vector<std::pair<Contender*, Setup>> cells;
  for (const std::size_t size : options.sizes) {
    for (const std::size_t subscribers : options.subscribers) {
      const Setup setup{size, subscribers, options.rate, options.count, ""};
      for (const auto& contender : contenders)
        if (wanted(options, *contender, setup)) cells.emplace_back(contender.get(), setup);
    }
  }
  return cells;
}

// A virtual machine's wake-ups can take twice as long in one minute as in the next: taking turns gives every
// contender, size and number of subscribers its share of both.
int sweep(const Options& options, const Contenders& contenders) {
  std::vector<Entry> entries;
  for (const auto& [contender, setup] : wanted_cells(options, contenders))
    entries.push_back({contender, setup});
  std::size_t done = 0;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    for (Entry& entry : entries) {
      measure_share(options, round, entry);
      show_progress(++done, options.rounds * entries.size());
    }
  }
  std::vector<Row> rows;
  for (Entry& entry : entries)
    rows.push_back(summarize(*entry.contender, entry.setup, std::move(entry.samples)));
  print_table(rows);
  return options.json.empty() || write_json(options.json, rows) ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
