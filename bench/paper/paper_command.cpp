// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <time.h>

#include <cstdio>
#include <memory>

#include "commands.h"
#include "load.h"
#include "paper/contender_table.h"
#include "paper/daemons.h"
#include "paper/evaluation.h"
#include "paper/paper_cells.h"
#include "paper/paper_options.h"
#include "paper/plots.h"
#include "paper/tool_tables.h"
#include "processes.h"

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

constexpr int interrupted_status = 130;  // as of a shell's command that SIGINT ended

std::string date() {
  const std::time_t now = std::time(nullptr);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  return text;
}

json description_of(const PaperOptions& options) {
  const json settings{{"rate_hz", options.cells.rate},
                      {"messages_of_a_cell", options.cells.count},
                      {"rounds", options.cells.rounds},
                      {"span", options.fills ? "allocate, fill, publish" : "publish"}};
  return {
      {"begun", date()}, {"settings", settings}, {"versions", contender_versions()}, {"machine", machine()}};
}

/// A name of --only that no contender has; empty: there is none.
std::string unknown_name(const Options& options, const Contestants& contestants) {
  for (const std::string& name : options.only)
    if (contestants.find(name) == nullptr) return name;
  return "";
}

MeasureCell measure_with(const Contestants& contestants, const PaperOptions& options) {
  return [&](const Cell& cell, std::size_t count) {
    Setup setup = setup_of(cell, options);
    setup.count = count;
    setup.name = unique_name();
    const auto load = cell.conditions.load ? std::make_unique<Load>() : nullptr;
    return measure(*contestants.find(cell.contender), setup);
  };
}

int fail(int status, const std::string& message) {
  std::fprintf(stderr, "tzc-bench paper: %s\n", message.c_str());
  return status;
}

void write_section(const Store& store, const std::string& file, Section section,
                   std::vector<Section>& sections) {
  if (section.table.rows.empty()) return;
  store.write(file, to_csv(section.table));
  sections.push_back(std::move(section));
}

/// What is counted and not measured: message types and changed lines.
std::vector<Section> counted_sections(const PaperOptions& options, const Store& store,
                                      std::vector<std::string>& said) {
  std::vector<Section> sections;
  write_section(store, "types.csv", types_section(types_table(options.types, said)), sections);
  write_section(store, "effort.csv", effort_section(effort_table(options.effort, said)), sections);
  return sections;
}

/// What could not be measured is not what was asked for: the status says so.
int evaluate(const PaperOptions& options, const Contestants& contestants) {
  const Store store(options.output);
  store.begin(description_of(options));
  std::vector<Cell> cells = cells_of(options, contestants);
  std::vector<std::string> obstacles;
  leave_out_impossible(options, contestants, cells, obstacles);
  const Daemons daemons(contestants.usual, cells, obstacles);
  const std::vector<Section> counted = counted_sections(options, store, obstacles);
  for (const std::string& obstacle : obstacles) fail(1, obstacle);
  const Progress progress = measure_missing(options.cells, cells, store, measure_with(contestants, options));
  if (progress == Progress::interrupted)
    return fail(interrupted_status, "interrupted; the same command goes on from here");
  write_reports(options.cells, cells, store, options.plots, counted);
  std::printf("%s\n", store.path_of("index.html").c_str());
  if (progress == Progress::with_failures)
    return fail(1, "some measurements failed; the same command tries them again");
  return obstacles.empty() ? 0 : 1;
}

}  // namespace

int run_paper(int argc, char** argv) {
  PaperOptions options;
  if (const auto over = parse_paper_options(argc, argv, options)) return *over;
  const Contestants contestants{all_contenders(), real_time_contenders()};
  const std::string unknown = unknown_name(options.cells, contestants);
  if (!unknown.empty())
    return fail(2, fmt::format("--only: there is no {}; there are {}", unknown, names_of(contestants.usual)));
  if (options.plots && gnuplot_version().empty())
    return fail(1, "gnuplot is not installed: install the package gnuplot-nox, or give --no-plots");
  hold_interrupts();
  try {
    return evaluate(options, contestants);
  } catch (const StoreError& error) {
    return interrupted() ? interrupted_status : fail(1, error.what());
  }
}

}  // namespace bench
}  // namespace tzc
