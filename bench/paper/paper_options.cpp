// SPDX-License-Identifier: BSD-3-Clause
#include "paper/paper_options.h"

#include "command_line/arguments.h"

namespace tzc {
namespace bench {
namespace {

constexpr char help[] =
    "The evaluation of the TZC paper (IROS 2019): latency, reliability and copies, as CSV, JSON, plots and a "
    "page.";
constexpr char footer[] = R"(
Run again with the same options, it goes on where it was interrupted.

Examples:
  tzc-bench paper                                  everything: some hours; results in ./tzc-paper
  tzc-bench paper --quick                          less than ten minutes: is all well?
  tzc-bench paper --dry-run                        what that measures, and how long it takes
  tzc-bench paper --sizes 4m --only tcpros,tzc-queue --output camera
  tzc-bench paper --types /opt/ros/noetic/share --effort src/my_camera
The machine should be idle: compare ratios within one run, never figures of two runs.)";

constexpr std::size_t kb = 1024, mb = kb * kb;

Options full() {
  Options options;
  options.sizes = {4 * kb, 16 * kb, 64 * kb, 256 * kb, mb, 4 * mb, 64 * mb};
  options.subscribers = {1, 2, 4, 8};
  options.rate = 30;
  options.count = 1000;
  options.rounds = 5;
  return options;
}

void shorten(const CLI::App& app, Options& options) {
  if (app.count("--sizes") == 0) options.sizes = {4 * kb, 256 * kb, 4 * mb};
  if (app.count("--subscribers") == 0) options.subscribers = {1, 4};
  if (app.count("--count") == 0) options.count = 30;
  if (app.count("--rounds") == 0) options.rounds = 1;
}

}  // namespace

std::optional<int> parse_paper_options(int argc, char** argv, PaperOptions& options) {
  CLI::App app(help, std::string("tzc-bench ") + argv[0]);
  app.footer(footer);
  options.cells = full();
  bool quick = false;
  add_choices(app, options.cells);
  app.add_flag("--quick", quick, "3 sizes, 1 and 4 subscribers, 30 messages, 1 round, unless given");
  app.add_option("--output", options.output, "folder of the results")->capture_default_str();
  app.add_flag("--load", options.load, "every case once more while all processors are busy");
  app.add_flag("--fill", options.fills, "the span begins before the message is allocated and filled");
  app.add_flag("--real-time,!--no-real-time", options.real_time,
               "the cases under SCHED_FIFO; given unless --only is");
  app.add_flag("--dry-run", options.dry_run,
               "print what a run would measure, how long, with how much memory");
  app.add_option("--publish", options.publish,
                 "folder for page, tables and plots, as a repository shows them")
      ->type_name("DIR");
  app.add_option("--types", options.types,
                 "count the message types below this folder; may be given more than once")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  app.add_option("--effort", options.effort,
                 "count the lines that tzc-rewrite changes in this package, as often as wanted")
      ->type_name("DIR")
      ->check(CLI::ExistingDirectory);
  app.add_flag("!--no-plots", options.plots, "tables only; gnuplot is not needed");
  const auto over = command_line::parse(app, argc, argv);
  if (quick) shorten(app, options.cells);
  options.wants_real_time = app.count("--real-time") > 0 && options.real_time;
  if (app.count("--real-time") == 0) options.real_time = options.cells.only.empty();
  return over;
}

}  // namespace bench
}  // namespace tzc
