// SPDX-License-Identifier: BSD-3-Clause
#include "paper/evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <iterator>
#include <set>

#include "paper/plots.h"
#include "paper/real_time_results.h"
#include "paper/tables.h"
#include "paper/turns.h"

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

std::string remark(const Summary& summary, double wanted_rate) {
  std::string text;
  if (!summary.holds_rate)
    text += fmt::format(", cannot hold the rate: {:.1f} of {:g} Hz", summary.rate, wanted_rate);
  if (mean_share(summary) < 1) text += fmt::format(", {:.1f} % delivered", 100 * mean_share(summary));
  return text;
}

void tell(const CellResult& result, std::size_t round, double wanted_rate, const std::string& left) {
  const Summary summary = summarize({result.cell, {*result.rounds.find(round)}}, wanted_rate);
  const std::string median =
      summary.latency_us ? fmt::format("median {:.1f} µs", summary.latency_us->median) : "nothing arrived";
  fmt::print(stderr, "{}{}{}\n", median, remark(summary, wanted_rate), left);
}

void announce(const Turn& turn, std::size_t number, std::size_t of) {
  const Cell& cell = *turn.cell;
  fmt::print(stderr, "[{}/{}] {}, {}, {}{}{}, round {}: ", number, of, cell.contender,
             size_text(cell.size_bytes), counted(cell.subscribers, "subscriber"),
             cell.conditions.real_time ? ", real time" : "", cell.conditions.load ? ", under load" : "",
             turn.round + 1);
}

/// "; 3 h 20 min left"
std::string time_left(std::size_t next, const std::vector<Turn>& turns, const Timetable& timetable) {
  return next == turns.size() ? "" : "; " + duration_text(timetable.seconds_from(next, turns)) + " left";
}

void tell_plan(const std::vector<Cell>& cells, const std::vector<Turn>& turns, const Timetable& timetable) {
  if (cells.empty()) return void(std::fprintf(stderr, "nothing of it can be measured here\n"));
  if (turns.empty()) return void(std::fprintf(stderr, "everything is measured already\n"));
  fmt::print(stderr, "{}, about {}\n", counted(turns.size(), "measurement"),
             duration_text(timetable.seconds_from(0, turns)));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Of all cells, what was measured under these conditions.
std::vector<Summary> under(const Conditions& conditions, const std::vector<Summary>& summaries) {
  std::vector<Summary> chosen;
  std::copy_if(summaries.begin(), summaries.end(), std::back_inserter(chosen),
               [&](const Summary& summary) { return summary.cell.conditions == conditions; });
  return chosen;
}

void add_plot(const Store& store, const std::string& name, const std::string& script,
              std::vector<Plot>& plots) {
  std::string svg = draw(store, name, script);
  if (!svg.empty()) plots.push_back({name, std::move(svg)});
}

/// The plots of latencies, one for each number of subscribers.
std::vector<Plot> draw_latencies(const std::vector<Summary>& summaries, const Store& store) {
  std::set<std::size_t> numbers;
  for (const Summary& summary : summaries) numbers.insert(summary.cell.subscribers);
  std::vector<Plot> plots;
  for (const std::size_t subscribers : numbers)
    add_plot(store, plot_name(subscribers, summaries.front().cell.conditions),
             plot_script(summaries, subscribers), plots);
  return plots;
}

void write_json(const Store& store, const std::vector<CellResult>& results,
                const std::vector<Summary>& summaries) {
  json document{{"run", json::parse(store.read("run.json"))}, {"cells", json::array()}};
  for (std::size_t i = 0; i < results.size(); ++i)
    document["cells"].push_back(to_json(results[i], summaries[i]));
  store.write("results.json", document.dump() + "\n");
}

std::vector<CellResult> measured(const std::vector<Cell>& cells, const Store& store) {
  std::vector<CellResult> results = store.load(cells);
  const auto empty = [](const CellResult& result) { return result.rounds.empty(); };
  results.erase(std::remove_if(results.begin(), results.end(), empty), results.end());
  return results;
}

/// Draws the plots, too.
std::vector<Section> sections_of(const Options& options, const std::vector<CellResult>& results,
                                 const std::vector<Summary>& summaries, const Store& store, bool with_plots) {
  const std::vector<Summary> main = under(usual, summaries), loaded = under(under_load, summaries);
  const std::vector<RealTimeFigures> real_time = real_time_figures(results, options.rate);
  std::vector<Plot> main_plots, load_plots, real_time_plots;
  if (with_plots) {
    main_plots = draw_latencies(main, store);
    load_plots = draw_latencies(loaded, store);
    add_plot(store, "real-time", real_time_script(real_time), real_time_plots);
  }
  std::vector<Section> sections = usual_sections(main, std::move(main_plots));
  for (Section& section : load_sections(loaded, std::move(load_plots)))
    sections.push_back(std::move(section));
  sections.push_back(real_time_section(real_time, std::move(real_time_plots)));
  return sections;
}

/// The page, its tables, and the page for a repository.
void write_sections(const Store& store, std::vector<Section> sections, const std::vector<Section>& more) {
  sections.insert(sections.end(), more.begin(), more.end());
  std::set<std::string> drawn;
  for (const Section& section : sections) {
    for (const Plot& plot : section.plots) drawn.insert(plot.name);
    if (section.table.rows.empty())
      store.remove(section.file);  // an earlier run's
    else
      store.write(section.file, to_csv(section.table));
  }
  remove_plots_but(drawn, store);
  const json run = json::parse(store.read("run.json"));
  store.write("index.html", page_of(run, sections));
  store.write("README.md", markdown_of(run, sections));
}

}  // namespace

Progress measure_missing(const Options& options, const std::vector<Cell>& cells, const Store& store,
                         const MeasureCell& measure) {
  std::vector<CellResult> results = store.load(cells);
  const std::vector<Turn> turns = turns_of(options, results);
  Timetable timetable(options.rate, results);
  tell_plan(cells, turns, timetable);
  bool failures = false;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    announce(turns[i], i + 1, turns.size());
    const auto start = std::chrono::steady_clock::now();
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
    timetable.add(turns[i], round, seconds_since(start));
    result->rounds.emplace(turns[i].round, std::move(round));
    store.save(*result);
    tell(*result, turns[i].round, options.rate, time_left(i + 1, turns, timetable));
  }
  return failures ? Progress::with_failures : Progress::complete;
}

void write_reports(const Options& options, const std::vector<Cell>& cells, const Store& store,
                   bool with_plots, const std::vector<Section>& more) {
  const std::vector<CellResult> results = measured(cells, store);
  std::vector<Summary> summaries;
  for (const CellResult& result : results) summaries.push_back(summarize(result, options.rate));
  write_json(store, results, summaries);
  write_sections(store, sections_of(options, results, summaries, store, with_plots), more);
}

}  // namespace bench
}  // namespace tzc
