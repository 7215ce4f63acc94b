// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "command_line/arguments.h"

namespace tzc::monitor {
namespace {

const char* const description =
    "Shows the topics that nodes publish with TZC: rates, shared memory, what was dropped, and for each\n"
    "connection whether it is shared or on TCPROS, and why. In a terminal it refreshes each second until\n"
    "Ctrl-C. It reads pages that the nodes keep anyway, so watching costs them nothing.";

const char* const footer =
    "\nExamples:\n"
    "  tzc-monitor                               all nodes of this user, live\n"
    "  tzc-monitor --once --topic /camera/image  one table of one topic\n"
    "  tzc-monitor --json | jq '.nodes[].topics[].connections[]'\n"
    "  tzc-monitor --why /viewer /camera/image   is this connection shared, and if not, why?\n"
    "  tzc-monitor --join-trace trace.json.* >all.json   one trace of several processes\n"
    "\nExit status: 0 something was found, 1 nothing was found, 2 error in the command line, a trace that\n"
    "cannot be joined, or output that cannot be written.\n";

void check(const Options& options) {
  const bool is_live = !options.once && !options.json && options.why.empty() && options.traces.empty();
  if (is_live && options.interval_s < 0.1)
    throw CLI::ValidationError("--interval", "at least 0.1 seconds, unless --once is given");
}

}  // namespace

std::optional<Options> parse_options(int argc, char** argv, int& status) {
  Options options;
  CLI::App app(description, "tzc-monitor");
  app.footer(footer);
  app.set_version_flag("--version", "tzc-monitor " TZC_VERSION);
  app.add_flag("--once", options.once,
               "print one table and end; the default where the output is no terminal");
  CLI::Option* const json = app.add_flag("--json", options.json, "print one JSON document and end");
  CLI::Option* const topic = app.add_option("--topic", options.topic, "this topic only")->type_name("NAME");
  CLI::Option* const interval =
      app.add_option("--interval", options.interval_s,
                     "seconds between two looks, over which rates are counted; 0 with --once: no rates")
          ->type_name("SECONDS")
          ->check(command_line::number_between(0, 3600))
          ->capture_default_str();
  CLI::Option* const why =
      app.add_option("--why", options.why, "why the connections of NODE on TOPIC are shared or not, in words")
          ->type_name("NODE TOPIC")
          ->expected(2)
          ->excludes(json)
          ->excludes(topic)
          ->excludes(interval);
  app.add_option(
         "--join-trace", options.traces,
         "print the traces that processes wrote with TZC_TRACE as one, for Perfetto or chrome://tracing")
      ->type_name("FILE...")
      ->excludes(json)
      ->excludes(topic)
      ->excludes(interval)
      ->excludes(why);
  app.callback([&] { check(options); });
  const std::optional<int> over = command_line::parse(app, argc, argv);
  status = over.value_or(0);
  return over ? std::nullopt : std::make_optional(options);
}

}  // namespace tzc::monitor
