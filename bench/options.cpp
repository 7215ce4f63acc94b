// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "command_line/arguments.h"
#include "environment.h"
#include "measure.h"

namespace tzc {
namespace bench {
namespace {

constexpr char examples[] = R"(
Examples:
  tzc-bench core --sizes 4k,4m --subscribers 8        two sizes, 8 subscribers
  tzc-bench core --only tzc,seqpacket --json a.json   two contenders, the figures as JSON too
  tzc-bench roscpp --count 1000 --rate 30             1000 messages at 30 Hz
The machine should be idle: compare ratios within one run, never figures of two runs.)";

constexpr char examples_of_one_case[] = R"(
Examples:
  tzc-bench sustained                             a minute of 4 MB at 200 Hz to 8 subscribers
  tzc-bench sustained --sizes 64k --count 60000   five minutes of 64 KB
There is one contender, tzc, and one case: --sizes and --subscribers take one number.)";

void add_messages(CLI::App& app, Options& options) {
  app.add_option("--rate", options.rate, "messages per second")
      ->check(command_line::number_between(0.001, 1e6))
      ->capture_default_str();
  app.add_option("--count", options.count, "messages of each contender, over all rounds")
      ->check(CLI::Range(std::size_t{1}, most_messages))
      ->capture_default_str();
}

void add_json(CLI::App& app, Options& options) {
  app.add_option("--json", options.json, "write the rows to this file")->check(command_line::file_to_write());
}

}  // namespace

std::size_t share_of(const Options& options, std::size_t round) {
  return options.count * (round + 1) / options.rounds - options.count * round / options.rounds;
}

void add_choices(CLI::App& app, Options& options) {
  app.add_option("--sizes", options.sizes, "bytes of a message: 4k,4m,64m")
      ->delimiter(',')
      ->transform(command_line::size_in_bytes())
      ->capture_default_str();
  app.add_option("--subscribers", options.subscribers, "how many of them: 1,8")
      ->delimiter(',')
      ->check(CLI::Range(std::size_t{1}, most_subscribers))
      ->capture_default_str();
  add_messages(app, options);
  app.add_option("--rounds", options.rounds, "the contenders take turns this often")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1000}))
      ->capture_default_str();
  app.add_option("--only", options.only, "these contenders: tzc,seqpacket")->delimiter(',');
  add_keep_settings(app);
}

std::optional<int> parse_options(int argc, char** argv, const std::string& help, Options& options) {
  CLI::App app(help, std::string("tzc-bench ") + argv[0]);
  app.footer(examples);
  add_choices(app, options);
  add_json(app, options);
  return command_line::parse(app, argc, argv);
}

std::optional<int> parse_one_case(int argc, char** argv, const std::string& help, Options& options) {
  CLI::App app(help, std::string("tzc-bench ") + argv[0]);
  app.footer(examples_of_one_case);
  app.add_option("--sizes", options.sizes.front(), "bytes of a message: 4m")
      ->transform(command_line::size_in_bytes())
      ->capture_default_str();
  app.add_option("--subscribers", options.subscribers.front(), "how many of them: 8")
      ->check(CLI::Range(std::size_t{1}, most_subscribers))
      ->capture_default_str();
  add_messages(app, options);
  add_keep_settings(app);
  add_json(app, options);
  return command_line::parse(app, argc, argv);
}

}  // namespace bench
}  // namespace tzc
