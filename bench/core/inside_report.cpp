// SPDX-License-Identifier: BSD-3-Clause
#include "inside_report.h"

#include <benchmark/benchmark.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "environment.h"
#include "report.h"

namespace tzc {
namespace bench {
namespace {

constexpr char usage[] = R"(What allocate and publish cost by themselves.
Usage: tzc-bench inside [--json FILE] [--keep-settings] [--benchmark_filter=REGEX] [other options of Google Benchmark]
--keep-settings: measure with the TZC_ variables of the environment, which are refused otherwise

Examples:
  tzc-bench inside --json inside.json
  tzc-bench inside --benchmark_filter=allocate --benchmark_repetitions=20
)";
char repetitions[] = "--benchmark_repetitions=5";

/// Prints what Google Benchmark prints, and keeps each repetition.
class Collector final : public benchmark::ConsoleReporter {
 public:
  Collector() : ConsoleReporter(::isatty(STDOUT_FILENO) != 0 ? OO_ColorTabular : OO_Tabular) {}

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type == Run::RT_Iteration && !run.error_occurred) add(run);
    }
  }

  std::vector<Row> rows() {
    std::vector<Row> rows;
    for (auto& [name, entry] : entries_) {
      std::vector<double>& all = entry.microseconds;
      std::sort(all.begin(), all.end());
      entry.row.median_us = all[all.size() / 2];
      entry.row.p99_us = all[all.size() * 99 / 100];
      rows.push_back(entry.row);
    }
    return rows;
  }

 private:
  struct Entry {
    Row row;
    std::vector<double> microseconds;
  };

  void add(const Run& run) {
    Entry& entry = entries_[run.run_name.str()];
    entry.row.contender = run.run_name.str();
    entry.row.size_bytes = counter(run, "size_bytes");
    entry.row.subscribers = counter(run, "subscribers");
    entry.row.sent += static_cast<std::size_t>(run.iterations);
    entry.row.delivered = entry.row.sent;
    entry.microseconds.push_back(run.real_accumulated_time / static_cast<double>(run.iterations) * 1e6);
  }

  static std::size_t counter(const Run& run, const char* name) {
    const auto found = run.counters.find(name);
    return found == run.counters.end() ? 0 : static_cast<std::size_t>(found->second.value);
  }

  std::map<std::string, Entry> entries_;
};

/// Takes --json FILE out of the arguments. False: no file follows.
bool take_json(std::vector<char*>& arguments, std::string& path) {
  for (auto it = arguments.begin(); it != arguments.end(); ++it) {
    if (std::strcmp(*it, "--json") != 0) continue;
    if (it + 1 == arguments.end()) return false;
    path = *(it + 1);
    arguments.erase(it, it + 2);
    return true;
  }
  return true;
}

bool take_flag(std::vector<char*>& arguments, const char* flag) {
  const auto out = std::remove_if(arguments.begin(), arguments.end(),
                                  [flag](const char* argument) { return std::strcmp(argument, flag) == 0; });
  const bool any = out != arguments.end();
  arguments.erase(out, arguments.end());
  return any;
}

/// Without what this program knows. The exit status where that is a mistake, which is said.
std::optional<int> take_own(std::vector<char*>& arguments, std::string& json) {
  std::string mistake;
  if (!take_flag(arguments, keep_settings)) mistake = refused_settings();
  if (!take_json(arguments, json)) mistake = "--json needs a file";
  if (mistake.empty()) return std::nullopt;
  std::fprintf(stderr, "tzc-bench inside: %s\n", mistake.c_str());
  return 2;
}

}  // namespace

int run_and_report(int argc, char** argv) {
  std::vector<char*> arguments(argv, argv + argc);
  if (argc > 1 && (std::strcmp(argv[1], "--help") == 0 || std::strcmp(argv[1], "-h") == 0)) {
    std::fputs(usage, stdout);
    return 0;
  }
  std::string json;
  if (const auto over = take_own(arguments, json)) return *over;
  arguments.insert(arguments.begin() + 1, repetitions);  // the user's own come later and count
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  return json.empty() || write_json(json, collector.rows()) ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
