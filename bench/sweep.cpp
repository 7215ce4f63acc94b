// SPDX-License-Identifier: BSD-3-Clause
#include "sweep.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "processes.h"

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

void complain(const Entry& entry, const std::string& what) {
  std::fprintf(stderr, "tzc-bench: %s, %zu bytes to %zu subscriber(s): %s; left out\n",
               entry.contender->name(), entry.setup.size_bytes, entry.setup.subscribers, what.c_str());
}

/// A failure has been said.
Outcome measure_share(const Options& options, std::size_t round, Entry& entry) {
  Setup share = entry.setup;
  share.count = share_of(options, round);
  share.name = unique_name();
  if (share.count == 0) return Outcome::complete;
  const Measurement measurement = measure(*entry.contender, share);
  if (measurement.outcome == Outcome::complete) add(measurement, entry.samples);
  if (measurement.outcome == Outcome::failed)
    complain(entry, "round " + std::to_string(round + 1) + " failed");
  return measurement.outcome;
}

/// The lines of the table; nothing for an entry of which no message arrived: false, and that has been said.
bool add_row(Entry& entry, std::vector<Row>& rows) {
  const bool any = !entry.samples.latency_ns.empty();
  if (any)
    rows.push_back(summarize(*entry.contender, entry.setup, std::move(entry.samples)));
  else
    complain(entry, "no message arrived");
  return any;
}

void show_progress(std::size_t done, std::size_t of) {
  if (::isatty(STDERR_FILENO) == 0) return;
  std::fprintf(stderr, done == of ? "\r\033[K" : "\rmeasured %zu of %zu", done, of);
}

/// Every entry's share of every round. failed: one has, and the others were measured.
Outcome measure_all(const Options& options, std::vector<Entry>& entries) {
  Outcome all = Outcome::complete;
  std::size_t done = 0;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    for (Entry& entry : entries) {
      const Outcome one = measure_share(options, round, entry);
      if (one == Outcome::interrupted) return one;
      if (one == Outcome::failed) all = one;
      show_progress(++done, options.rounds * entries.size());
    }
  }
  return all;
}

/// What an interruption leaves: the figures so far, and no file.
int show_interrupted(std::vector<Entry>& entries) {
  show_progress(1, 1);  // clears its line
  std::vector<Row> rows;
  for (Entry& entry : entries)
    if (!entry.samples.latency_ns.empty()) add_row(entry, rows);
  if (!rows.empty()) print_table(rows);
  std::fprintf(stderr, "tzc-bench: interrupted: these are the figures until then\n");
  return interrupted_status;
}

}  // namespace

std::string names_of(const Contenders& contenders) {
  std::string names;
  for (const auto& contender : contenders)
    names += (names.empty() ? "" : ", ") + std::string(contender->name());
  return names;
}

Contender* find_contender(const Contenders& contenders, const std::string& name) {
  const auto found = std::find_if(contenders.begin(), contenders.end(),
                                  [&](const auto& contender) { return contender->name() == name; });
  return found == contenders.end() ? nullptr : found->get();
}

std::string unknown_name(const Options& options, const std::function<bool(const std::string&)>& is_known) {
  const auto unknown = std::find_if_not(options.only.begin(), options.only.end(), is_known);
  return unknown == options.only.end() ? "" : *unknown;
}

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
  const auto is_known = [&](const std::string& name) { return find_contender(contenders, name) != nullptr; };
  const std::string unknown = unknown_name(options, is_known);
  if (!unknown.empty()) {
    std::fprintf(stderr, "tzc-bench: --only: there is no %s; there are %s\n", unknown.c_str(),
                 names_of(contenders).c_str());
    return 2;
  }
  std::vector<Entry> entries;
  for (const auto& [contender, setup] : wanted_cells(options, contenders))
    entries.push_back({contender, setup});
  if (entries.empty()) return std::fprintf(stderr, "tzc-bench: %s\n", nobody_takes_these_sizes), 2;
  const Outcome outcome = measure_all(options, entries);
  if (outcome == Outcome::interrupted) return show_interrupted(entries);
  bool failures = outcome == Outcome::failed;
  std::vector<Row> rows;
  for (Entry& entry : entries) failures |= !add_row(entry, rows);
  print_table(rows);
  const bool is_written = options.json.empty() || write_json(options.json, rows);
  return is_written && !failures ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
