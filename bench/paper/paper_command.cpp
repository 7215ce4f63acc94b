// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <time.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "commands.h"
#include "core/contenders.h"
#include "paper/evaluation.h"
#include "paper/paper_options.h"
#include "paper/plots.h"
#include "processes.h"
#include "sweep.h"
#ifdef TZC_BENCH_ROSCPP
#include "roscpp/contenders.h"
#include "roscpp/roscore.h"
#endif

namespace tzc {
namespace bench {
namespace {

using nlohmann::json;

constexpr int interrupted_status = 130;  // as of a shell's command that SIGINT ended

Contenders all_contenders() {
  Contenders contenders;
#ifdef TZC_BENCH_ROSCPP
  contenders.push_back(tcpros_contender());
  contenders.push_back(intraprocess_contender());
  contenders.push_back(tzc_queue_contender());
  contenders.push_back(tzc_direct_contender());
  contenders.push_back(asl_contender());
#endif
  contenders.push_back(ach_contender());
  contenders.push_back(tzc_reader_contender());
#ifdef TZC_BENCH_ICEORYX
  contenders.push_back(iceoryx_listener_contender());
#endif
  return contenders;
}

json versions() {
  json versions{{"tzc", TZC_VERSION}};
#ifdef TZC_BENCH_ROSCPP
  versions["roscpp"] = roscpp_version();
#endif
#ifdef TZC_BENCH_ICEORYX
  versions["iceoryx"] = iceoryx_version();
#endif
  return versions;
}

std::string date() {
  const std::time_t now = std::time(nullptr);
  char text[40];
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  return text;
}

json description_of(const Options& options) {
  const json settings{
      {"rate_hz", options.rate}, {"messages_of_a_cell", options.count}, {"rounds", options.rounds}};
  return {{"begun", date()}, {"settings", settings}, {"versions", versions()}, {"machine", machine()}};
}

/// A name of --only that no contender has; empty: there is none.
std::string unknown_name(const Options& options, const Contenders& contenders) {
  for (const std::string& name : options.only) {
    const auto named = [&](const auto& contender) { return contender->name() == name; };
    if (std::none_of(contenders.begin(), contenders.end(), named)) return name;
  }
  return "";
}

std::string names_of(const Contenders& contenders) {
  std::string names;
  for (const auto& contender : contenders)
    names += (names.empty() ? "" : ", ") + std::string(contender->name());
  return names;
}

bool any_of(const std::vector<Cell>& cells, const std::vector<std::string>& contenders) {
  return std::any_of(cells.begin(), cells.end(), [&](const Cell& cell) {
    return std::find(contenders.begin(), contenders.end(), cell.contender) != contenders.end();
  });
}

/// The daemons that the cells' contenders need, as long as it exists.
class Daemons {
 public:
  /// Takes cells away whose daemon does not start, and says so.
  explicit Daemons([[maybe_unused]] std::vector<Cell>& cells) {
#ifdef TZC_BENCH_ROSCPP
    const std::vector<std::string> of_ros{"tcpros", "intraprocess", "tzc-queue", "tzc-direct"};
    if (any_of(cells, of_ros)) core_ = std::make_unique<RosCore>();
    if (core_ != nullptr && !core_->running())
      leave_out(cells, of_ros, "rosmaster does not start: is ROS's environment set up (source setup.bash)?");
#endif
#ifdef TZC_BENCH_ICEORYX
    const std::vector<std::string> of_iceoryx{"iceoryx-listener"};
    if (any_of(cells, of_iceoryx)) roudi_ = std::make_unique<RouDi>();
    if (roudi_ != nullptr && !roudi_->running())
      leave_out(cells, of_iceoryx, "iox-roudi does not start: another one runs, or none is installed");
#endif
  }
  bool complete() const { return complete_; }

 private:
  void leave_out(std::vector<Cell>& cells, const std::vector<std::string>& contenders, const char* why) {
    std::fprintf(stderr, "tzc-bench paper: %s; left out: %s\n", why,
                 fmt::format("{}", fmt::join(contenders, ", ")).c_str());
    const auto out = std::remove_if(cells.begin(), cells.end(),
                                    [&](const Cell& cell) { return any_of({cell}, contenders); });
    cells.erase(out, cells.end());
    complete_ = false;
  }

#ifdef TZC_BENCH_ROSCPP
  std::unique_ptr<RosCore> core_;
#endif
#ifdef TZC_BENCH_ICEORYX
  std::unique_ptr<RouDi> roudi_;
#endif
  bool complete_ = true;
};

MeasureCell measure_with(const Contenders& contenders, const Options& options) {
  return [&](const Cell& cell, std::size_t count) {
    const auto contender = std::find_if(contenders.begin(), contenders.end(),
                                        [&](const auto& one) { return one->name() == cell.contender; });
    return measure(**contender, Setup{cell.size_bytes, cell.subscribers, options.rate, count, unique_name()});
  };
}

std::vector<Cell> cells_of(const Options& options, const Contenders& contenders) {
  std::vector<Cell> cells;
  for (const auto& [contender, setup] : wanted_cells(options, contenders))
    cells.push_back({contender->name(), setup.size_bytes, setup.subscribers});
  return cells;
}

int fail(int status, const std::string& message) {
  std::fprintf(stderr, "tzc-bench paper: %s\n", message.c_str());
  return status;
}

/// What could not be measured is not what was asked for: the status says so.
int evaluate(const PaperOptions& options, const Contenders& contenders) {
  const Store store(options.output);
  store.begin(description_of(options.cells));
  std::vector<Cell> cells = cells_of(options.cells, contenders);
  const Daemons daemons(cells);
  const Progress progress =
      measure_missing(options.cells, cells, store, measure_with(contenders, options.cells));
  if (progress == Progress::interrupted)
    return fail(interrupted_status, "interrupted; the same command goes on from here");
  write_reports(options.cells, cells, store, options.plots);
  std::printf("%s\n", store.path_of("index.html").c_str());
  if (progress == Progress::with_failures)
    return fail(1, "some measurements failed; the same command tries them again");
  return daemons.complete() ? 0 : 1;
}

}  // namespace

int run_paper(int argc, char** argv) {
  PaperOptions options;
  if (const auto over = parse_paper_options(argc, argv, options)) return *over;
  const Contenders contenders = all_contenders();
  const std::string unknown = unknown_name(options.cells, contenders);
  if (!unknown.empty())
    return fail(2, fmt::format("--only: there is no {}; there are {}", unknown, names_of(contenders)));
  if (options.plots && gnuplot_version().empty())
    return fail(1, "gnuplot is not installed: install the package gnuplot-nox, or give --no-plots");
  hold_interrupts();
  try {
    return evaluate(options, contenders);
  } catch (const StoreError& error) {
    return interrupted() ? interrupted_status : fail(1, error.what());
  }
}

}  // namespace bench
}  // namespace tzc
