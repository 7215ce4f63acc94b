// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <time.h>

#include <cstdio>
#include <functional>
#include <memory>
#include <system_error>

#include "commands.h"
#include "load.h"
#include "paper/contender_table.h"
#include "paper/counts.h"
#include "paper/daemons.h"
#include "paper/evaluation.h"
#include "paper/paper_cells.h"
#include "paper/paper_options.h"
#include "paper/plan.h"
#include "paper/plots.h"
#include "paper/publication.h"
#include "processes.h"

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

constexpr char plan_remarks[] =
    "Cases that cannot hold the rate take longer; the progress of a run tells what is left of it. What "
    "contenders "
    "need\n"
    "besides memory (a rosmaster, daemons, the network) is tried when a run begins.\n";

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

MeasureCell measure_with(const Contestants& contestants, const PaperOptions& options) {
  return [&](const Cell& cell, std::size_t count) {
    Setup setup = setup_of(cell, options);
    setup.count = count;
    setup.name = unique_name();
    const std::string obstacle = memory_obstacle(cell, options, contestants);  // others may have taken it
    if (!obstacle.empty()) return fmt::print(stderr, "{}: ", obstacle), Measurement();
    try {
      const auto load = cell.conditions.load ? std::make_unique<Load>() : nullptr;
      return measure(*contestants.find(cell.contender), setup);
    } catch (const std::system_error& error) {
      return fmt::print(stderr, "{}: ", error.what()), Measurement();
    }
  };
}

int fail(int status, const std::string& message) {
  std::fprintf(stderr, "tzc-bench paper: %s\n", message.c_str());
  return status;
}

/// Nothing, where no run has begun in this folder.
std::vector<CellResult> measured_already(const PaperOptions& options, const std::vector<Cell>& cells) {
  if (Store::has_begun(options.output)) {
    const Store store(options.output);
    store.begin(description_of(options));
    return store.load(cells);
  }
  std::vector<CellResult> results;
  for (const Cell& cell : cells) results.push_back({cell, {}});
  return results;
}

int show_plan(const PaperOptions& options, const Contestants& contestants) {
  std::vector<Cell> cells = cells_of(options, contestants);
  std::vector<std::string> obstacles;
  leave_out_impossible(options, contestants, cells, obstacles);
  const std::vector<CellResult> results = measured_already(options, cells);
  const auto memory = [&](const Cell& cell) { return memory_of(cell, options, contestants); };
  fmt::print("{}{}", plan_text(options.cells, results, memory), plan_remarks);
  for (const std::string& obstacle : obstacles) fmt::print("{}\n", obstacle);
  return 0;
}

/// What could not be measured is not what was asked for: the status says so.
int evaluate(const PaperOptions& options, const Contestants& contestants) {
  std::vector<Cell> cells = cells_of(options, contestants);
  const Store store(options.output);
  store.begin(description_of(options));
  std::vector<std::string> obstacles;
  leave_out_impossible(options, contestants, cells, obstacles);
  const Daemons daemons(contestants.usual, cells, obstacles);
  const std::vector<Section> counted = counted_sections(store, options, obstacles);
  for (const std::string& obstacle : obstacles) fail(1, obstacle);
  const Progress progress = measure_missing(options.cells, cells, store, measure_with(contestants, options));
  if (progress == Progress::interrupted)
    return fail(interrupted_status, "interrupted; the same command goes on from here");
  std::vector<Cell> all = store.cells();  // earlier runs may have measured others
  sort(all, contestants);
  write_reports(options.cells, all, store, options.plots, counted);
  std::printf("%s\n", store.path_of("index.html").c_str());
  if (!options.publish.empty()) publish(store, options.publish);
  if (progress == Progress::with_failures)
    return fail(1, "some measurements failed; the same command tries them again");
  return obstacles.empty() ? 0 : 1;
}

int with_store_errors(const std::function<int()>& command) {
  try {
    return command();
  } catch (const StoreError& error) {
    return interrupted() ? interrupted_status : fail(1, error.what());
  }
}

}  // namespace

int run_paper(int argc, char** argv) {
  PaperOptions options;
  if (const auto over = parse_paper_options(argc, argv, options)) return *over;
  const Contestants contestants{all_contenders(), real_time_contenders()};
  const auto is_known = [&](const std::string& name) { return contestants.find(name) != nullptr; };
  const std::string unknown = unknown_name(options.cells, is_known);
  if (!unknown.empty())
    return fail(2, fmt::format("--only: there is no {}; there are {}", unknown, names_of(contestants.usual)));
  const std::string wish = impossible_wish(options, contestants, cells_of(options, contestants));
  if (!wish.empty()) return fail(2, wish);
  if (options.dry_run) return with_store_errors([&] { return show_plan(options, contestants); });
  if (options.plots && gnuplot_version().empty())
    return fail(1, "gnuplot is not installed: install the package gnuplot-nox, or give --no-plots");
  hold_interrupts();
  return with_store_errors([&] { return evaluate(options, contestants); });
}

}  // namespace bench
}  // namespace tzc
