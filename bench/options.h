// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace tzc {
namespace bench {

/// The options of every latency command; `tzc-bench COMMAND --help` describes them.
struct Options {
  std::vector<std::size_t> sizes{4096, 1 << 20, 4 << 20, 64 << 20};
  std::vector<std::size_t> subscribers{1, 8};
  double rate = 100;
  std::size_t count = 500;
  std::size_t rounds = 10;
  std::vector<std::string> only;
  std::string json;
};

/// The messages of one contender in this round: count is shared out over the rounds.
std::size_t share_of(const Options& options, std::size_t round);

/// Adds the options that choose what is measured, and --keep-settings: all but --json.
void add_choices(CLI::App& app, Options& options);

/// Sets the options that the command line names. The result is command_line::parse's.
std::optional<int> parse_options(int argc, char** argv, const std::string& help, Options& options);

/// The same for a command with one contender and one case: --sizes and --subscribers take one number each, and nothing takes
/// turns. `options` has the one size and the one number of subscribers by default.
std::optional<int> parse_one_case(int argc, char** argv, const std::string& help, Options& options);

}  // namespace bench
}  // namespace tzc
