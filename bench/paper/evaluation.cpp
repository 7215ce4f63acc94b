// SPDX-License-Identifier: BSD-3-Clause
#include "paper/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "paper/plots.h"
#include "paper/real_time_results.h"
#include "paper/tables.h"

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

/// One measurement that is to be made.
struct Turn {
  const Cell* cell;
  std::size_t round;
  std::size_t count;
};

// A virtual machine's wake-ups can take twice as long in one minute as in the next: taking turns gives every cell its
// share of both.
std::vector<Turn> turns_of(const Options& options, const std::vector<CellResult>& results) {
  std::vector<Turn> turns;
  for (std::size_t round = 0; round < options.rounds; ++round) {
    const std::size_t count = share_of(options, round);
    for (const CellResult& result : results)
      if (count > 0 && result.rounds.count(round) == 0) turns.push_back({&result.cell, round, count});
  }
  return turns;
}

std::string remark(const Summary& summary, double wanted_rate) {
  std::string text;
  if (!summary.holds_rate)
    text += fmt::format(", cannot hold the rate: {:.1f} of {:g} Hz", summary.rate, wanted_rate);
  if (mean_share(summary) < 1) text += fmt::format(", {:.1f} % delivered", 100 * mean_share(summary));
  return text;
}

void tell(const CellResult& result, std::size_t round, double wanted_rate) {
  const Summary summary = summarize({result.cell, {*result.rounds.find(round)}}, wanted_rate);
  const std::string median =
      summary.latency_us ? fmt::format("median {:.1f} µs", summary.latency_us->median) : "nothing arrived";
  fmt::print(stderr, "{}{}\n", median, remark(summary, wanted_rate));
}

std::string counted(std::size_t number, const char* noun) {
  return fmt::format("{} {}{}", number, noun, number == 1 ? "" : "s");
}

void announce(const Turn& turn, std::size_t number, std::size_t of) {
  const Cell& cell = *turn.cell;
  fmt::print(stderr, "[{}/{}] {}, {}, {}{}{}, round {}: ", number, of, cell.contender,
             size_text(cell.size_bytes), counted(cell.subscribers, "subscriber"),
             cell.conditions.real_time ? ", real time" : "", cell.conditions.load ? ", under load" : "",
             turn.round + 1);
}

std::vector<CellResult> load(const std::vector<Cell>& cells, const Store& store) {
  std::vector<CellResult> results;
  for (const Cell& cell : cells) results.push_back(store.load(cell));
  return results;
}

void estimate(const Options& options, const std::vector<Turn>& turns) {
  if (turns.empty()) return void(std::fprintf(stderr, "everything is measured already\n"));
  constexpr double start_and_end = 1, warm_up_messages = 20;
  double seconds = 0;
  for (const Turn& turn : turns)
    seconds += start_and_end + (warm_up_messages + static_cast<double>(turn.count)) / options.rate;
  fmt::print(stderr, "{}, about {}\n", counted(turns.size(), "measurement"),
             counted(static_cast<std::size_t>(seconds / 60) + 1, "minute"));
}

/// Of all cells, what was measured under these conditions.
std::vector<Summary> under(const Conditions& conditions, const std::vector<Summary>& summaries) {
  std::vector<Summary> chosen;
  std::copy_if(summaries.begin(), summaries.end(), std::back_inserter(chosen),
               [&](const Summary& summary) { return summary.cell.conditions == conditions; });
  return chosen;
}

/// The plots of latencies, one for each number of subscribers.
std::vector<std::string> draw_latencies(const Options& options, const std::vector<Summary>& summaries,
                                        const Store& store) {
  std::vector<std::string> plots;
  if (summaries.empty()) return plots;
  for (const std::size_t subscribers : options.subscribers) {
    const std::string name = plot_name(subscribers, summaries.front().cell.conditions);
    plots.push_back(draw(store, name, plot_script(summaries, subscribers)));
  }
  return plots;
}

void write_table(const Store& store, const std::string& name, const Table& table) {
  if (!table.rows.empty()) store.write(name, to_csv(table));
}

void write_json(const Store& store, const std::vector<CellResult>& results,
                const std::vector<Summary>& summaries) {
  json document{{"run", json::parse(store.read("run.json"))}, {"cells", json::array()}};
  for (std::size_t i = 0; i < results.size(); ++i)
    document["cells"].push_back(to_json(results[i], summaries[i]));
  store.write("results.json", document.dump() + "\n");
}

}  // namespace

Progress measure_missing(const Options& options, const std::vector<Cell>& cells, const Store& store,
                         const MeasureCell& measure) {
  std::vector<CellResult> results = load(cells, store);
  const std::vector<Turn> turns = turns_of(options, results);
  estimate(options, turns);
  bool failures = false;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    announce(turns[i], i + 1, turns.size());
    Measurement round = measure(*turns[i].cell, turns[i].count);
    if (round.outcome == Outcome::interrupted) {
      std::fprintf(stderr, "interrupted\n");
      return Progress::interrupted;
    }
    if (round.outcome == Outcome::failed) {
      std::fprintf(stderr, "failed\n");
      failures = true;
      continue;
    }
    const auto result = std::find_if(results.begin(), results.end(),
                                     [&](const CellResult& one) { return &one.cell == turns[i].cell; });
    result->rounds.emplace(turns[i].round, std::move(round));
    store.save(*result);
    tell(*result, turns[i].round, options.rate);
  }
  return failures ? Progress::with_failures : Progress::complete;
}

void write_reports(const Options& options, const std::vector<Cell>& cells, const Store& store,
                   bool with_plots, const std::vector<Section>& more) {
  std::vector<CellResult> results = load(cells, store);
  const auto empty = [](const CellResult& result) { return result.rounds.empty(); };
  results.erase(std::remove_if(results.begin(), results.end(), empty), results.end());
  std::vector<Summary> summaries;
  for (const CellResult& result : results) summaries.push_back(summarize(result, options.rate));
  const std::vector<Summary> main = under(usual, summaries), loaded = under(under_load, summaries);
  const std::vector<RealTimeFigures> real_time = real_time_figures(results, options.rate);
  store.write("latency.csv", to_csv(latency_table(main)));
  store.write("reliability.csv", to_csv(reliability_table(main)));
  store.write("copies.csv", to_csv(copies_table(main)));
  write_table(store, "latency-load.csv", latency_table(loaded));
  write_table(store, "reliability-load.csv", reliability_table(loaded));
  write_table(store, "real-time.csv", real_time_table(real_time));
  write_json(store, results, summaries);
  std::vector<std::string> main_plots, load_plots, real_time_plots;
  if (with_plots) {
    main_plots = draw_latencies(options, main, store);
    load_plots = draw_latencies(options, loaded, store);
    real_time_plots = {draw(store, "real-time", real_time_script(real_time))};
  }
  std::vector<Section> sections{latency_section(main, main_plots), reliability_section(main),
                                copies_section(main), load_section(loaded, load_plots),
                                real_time_section(real_time, real_time_plots)};
  sections.insert(sections.end(), more.begin(), more.end());
  store.write("index.html", page_of(json::parse(store.read("run.json")), sections));
}

}  // namespace bench
}  // namespace tzc
