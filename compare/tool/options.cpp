// SPDX-License-Identifier: BSD-3-Clause
#include "tool/options.h"

#include <cstdlib>
#include <regex>

#include "command_line/arguments.h"

namespace tzc::compare {
namespace {

const char* const description =
    "Runs an original and a ported workspace on the same input and compares what their nodes publish, "
    "message by\n"
    "message and byte by byte (header.seq aside), with latency, processor time and copies of both. The "
    "original runs\n"
    "twice, so that the port may differ where the original's own runs differ.";

const char* const footer =
    "\nExamples:\n"
    "  tzc-compare ws ws_tzc --launch 'my_robot perception.launch' --bag drive.bag\n"
    "  tzc-compare ws ws_tzc --launch 'my_robot sim.launch gui:=false' --duration 20 --topic '/camera/.*'\n"
    "  tzc-compare ws ws_tzc --command 'rosrun my_camera camera_node _count:=100' --json result.json\n"
    "\nExit status: 0 equal, 1 different, 2 error (nothing could be compared), 130 stopped by Ctrl-C.\n";

// Topics of image_transport's plugins: lossy copies of a raw topic, published only because the recorder
// subscribes.
const char* const transports = ".*/(compressed|compressedDepth|theora)(/.*)?";

const CLI::Validator seconds = command_line::number_between(0.001, 1e6);

std::string check_expression(const std::string& text) {
  try {
    (void)std::regex(text);
    return "";
  } catch (const std::regex_error& error) {
    return text + " is no regular expression: " + error.what();
  }
}

void add_input(CLI::App& app, Options& options) {
  Input& input = options.input;
  app.add_option("--launch", input.launches,
                 "arguments of roslaunch: 'PACKAGE FILE.launch [ARG:=VALUE...]' (repeatable)")
      ->type_name("ARGS")
      ->allow_extra_args(false);
  app.add_option("--command", input.commands,
                 "a command for bash, in the workspace's environment (repeatable)")
      ->type_name("COMMAND")
      ->allow_extra_args(false);
  CLI::Option* const bag = app.add_option("--bag", input.bag, "a recording to play, once all nodes are there")
                               ->check(CLI::ExistingFile);
  app.add_option("--play-args", input.play_arguments,
                 "further arguments of rosbag play, one each: --play-args=--rate=0.5")
      ->type_name("ARG")
      ->allow_extra_args(false)
      ->needs(bag);
  app.add_flag("--clock", input.simulates_time,
               "nodes use the bag's time (/use_sim_time, rosbag play --clock)")
      ->needs(bag);
  app.add_option("--duration", input.duration_s,
                 "seconds that a run without a bag lasts, if it does not end earlier")
      ->check(seconds)
      ->capture_default_str();
  app.add_option("--settle", input.settle_s,
                 "seconds without a change of the graph after which all nodes are there")
      ->check(seconds)
      ->capture_default_str();
  app.add_option("--quiet-time", input.quiet_s,
                 "seconds without a message after which nothing more comes after the bag")
      ->check(seconds)
      ->capture_default_str()
      ->needs(bag);
  app.add_option("--start-timeout", input.start_timeout_s, "seconds that the nodes may take to start")
      ->check(seconds)
      ->capture_default_str();
}

void add_comparison(CLI::App& app, Options& options) {
  app.add_option("--topic", options.recorded.topics,
                 "compare these topics only (regular expression, repeatable)")
      ->type_name("REGEX")
      ->check(check_expression)
      ->allow_extra_args(false);
  app.add_option("--exclude", options.recorded.excluded,
                 "leave these topics out (regular expression, repeatable); by default\n"
                 "what image_transport makes of a raw topic: " +
                     std::string(transports))
      ->type_name("REGEX")
      ->check(check_expression)
      ->allow_extra_args(false);
  app.add_flag("--ignore-stamps", options.left_out.header_stamps, "do not compare the stamps of headers");
  app.add_option("--ignore", options.left_out.fields,
                 "do not compare this field, nor what is inside it: 'poses[].pose' (repeatable)")
      ->type_name("FIELD")
      ->allow_extra_args(false);
  app.add_option_function<double>(
         "--allow-loss", [&](double percent) { options.rules.allowed_loss = percent / 100; },
         "percent of a topic's messages that may be lost or extra (0)")
      ->type_name("PERCENT")
      ->check(command_line::number_between(0, 100));
  app.add_flag("--strict", options.rules.strict,
               "fields that the original does not repeat itself count as different");
  app.add_option("--runs", options.runs, "runs of the original")
      ->check(CLI::Range(1, 20))
      ->capture_default_str();
  app.add_flag("--tcpros", options.recorded.over_tcpros,
               "record as an unported node does, not through shared memory");
}

void add_output(CLI::App& app, Options& options) {
  app.add_option("--json", options.json, "write the result as JSON, - for standard output")
      ->check([](const std::string& text) { return text == "-" ? "" : command_line::file_to_write()(text); })
      ->type_name("FILE");
  app.add_option("--keep", options.keep, "keep the recordings (bags) and the logs in this folder")
      ->type_name("FOLDER");
  app.add_option("--scratch", options.scratch, "where recordings go while it runs; they can be large")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
  app.add_flag("-q,--quiet", options.is_quiet, "no progress");
}

}  // namespace

std::optional<Options> parse_options(int argc, char** argv, int& status) {
  Options options;
  const char* const temporary = std::getenv("TMPDIR");
  options.scratch = temporary && *temporary ? temporary : "/tmp";
  CLI::App app(description, "tzc-compare");
  app.footer(footer);
  app.set_version_flag("--version", "tzc-compare " TZC_VERSION);
  app.add_option("ORIGINAL", options.original, "the original workspace, built, or its setup.bash")
      ->required();
  app.add_option("PORT", options.port, "the ported workspace, built, or its setup.bash")->required();
  add_input(app, options);
  add_comparison(app, options);
  add_output(app, options);
  app.callback([&] {
    if (options.input.launches.empty() && options.input.commands.empty())
      throw CLI::RequiredError("--launch or --command");
  });
  const std::optional<int> over = command_line::parse(app, argc, argv);
  status = over.value_or(0);
  if (over) return std::nullopt;
  if (options.recorded.excluded.empty()) options.recorded.excluded = {transports};
  return options;
}

}  // namespace tzc::compare
