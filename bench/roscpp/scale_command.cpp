// SPDX-License-Identifier: BSD-3-Clause
// What many topics cost each process: threads, descriptors, memory, and time until all share memory.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "command_line/arguments.h"
#include "commands.h"
#include "environment.h"
#include "options.h"
#include "report.h"
#include "roscpp/crowd.h"
#include "roscpp/roscore.h"

namespace tzc {
namespace bench {
namespace {

constexpr char examples[] = R"(
Examples:
  tzc-bench scale                                     12 topics, 3 subscribing processes
  tzc-bench scale --topics 100 --memory 64m           each publisher has 64 MB
  tzc-bench scale --full --json scale.json            80 topics x 8 processes with 1024 descriptors, 300 x 10
One process publishes all topics; each of the others subscribes to all of them.)";

/// A row of the table: one crowd with one transport.
struct CrowdRow {
  const char* transport;
  Crowd crowd;
  CrowdResult result;
};

std::vector<Crowd> full_crowds() {
  Crowd limited, many;
  limited.topics = 80;
  limited.subscribers = 8;
  limited.memory_bytes = std::size_t{64} << 20;
  limited.descriptors = 1024;
  many.topics = 300;
  many.subscribers = 10;
  return {limited, many};
}

nlohmann::json to_json(const Needs& needs) {
  return {{"threads", needs.threads}, {"descriptors", needs.descriptors}, {"private_kb", needs.private_kb}};
}

nlohmann::json to_json(const CrowdRow& row) {
  return {{"transport", row.transport},
          {"topics", row.crowd.topics},
          {"subscribers", row.crowd.subscribers},
          {"connected", row.result.connected},
          {"upgraded", row.result.upgraded},
          {"delivered", row.result.delivered},
          {"connected_s", row.result.connected_s},
          {"upgraded_s", row.result.upgraded_s},
          {"publisher", to_json(row.result.publisher)},
          {"subscriber", to_json(row.result.subscriber)}};
}

void print_header() {
  std::printf(
      "%-9s %6s %11s | %-27s | %-27s |\n%-9s %6s %11s | %7s %11s %7s | %7s %11s %7s | %9s %11s %8s %10s "
      "%9s\n",
      "", "", "", "publisher", "subscriber, the most", "transport", "topics", "subscribers", "threads",
      "descriptors", "own_kb", "threads", "descriptors", "own_kb", "connected", "connected_s", "upgraded",
      "upgraded_s", "delivered");
}

void print(const CrowdRow& row) {
  const CrowdResult& result = row.result;
  std::printf("%-9s %6zu %11zu | %7zu %11zu %7zu | %7zu %11zu %7zu | %9zu %11.1f %8zu %10.1f %9zu\n",
              row.transport, row.crowd.topics, row.crowd.subscribers, result.publisher.threads,
              result.publisher.descriptors, result.publisher.private_kb, result.subscriber.threads,
              result.subscriber.descriptors, result.subscriber.private_kb, result.connected,
              result.connected_s, result.upgraded, result.upgraded_s, result.delivered);
  std::fflush(stdout);
}

bool measure(const Crowd& crowd, std::vector<CrowdRow>& rows) {
  const RosCore core;
  if (!core.running()) {
    std::fprintf(stderr, "rosmaster does not start: is ROS's environment set up (source setup.bash)?\n");
    return false;
  }
  for (const Transport transport : {Transport::tcpros, Transport::tzc}) {
    CrowdRow row{transport == Transport::tcpros ? "tcpros" : "tzc", crowd, {}};
    if (!run_crowd(crowd, transport, row.result)) {
      std::fprintf(stderr, "%s: a process of %zu topics ended before its time\n", row.transport,
                   crowd.topics);
      return false;
    }
    print(row);
    rows.push_back(row);
  }
  return true;
}

void add_options(CLI::App& app, Crowd& crowd, bool& full, std::string& json) {
  app.footer(examples);
  app.add_option("--topics", crowd.topics, "publishers, in one process")
      ->check(CLI::Range(std::size_t{1}, std::size_t{10'000}))
      ->capture_default_str();
  app.add_option("--subscribers", crowd.subscribers, "processes that subscribe to all topics")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100}))
      ->capture_default_str();
  app.add_option("--memory", crowd.memory_bytes, "of each publisher: 64m; 0: its default")
      ->transform(command_line::size_in_bytes())
      ->capture_default_str();
  app.add_option("--descriptors", crowd.descriptors, "that a process may have; 0: as many as permitted")
      ->check(CLI::Range(std::size_t{0}, std::size_t{1} << 30))
      ->capture_default_str();
  app.add_option("--patience", crowd.patience_s, "seconds without progress before a run goes on")
      ->check(CLI::Range(std::size_t{1}, std::size_t{86'400}))
      ->capture_default_str();
  app.add_flag("--full", full, "the two large crowds in place of the options above");
  app.add_option("--json", json, "write the rows to this file")->check(command_line::file_to_write());
  add_keep_settings(app);
}

}  // namespace

int run_scale(int argc, char** argv) {
  CLI::App app("What many topics cost each process, next to plain roscpp.",
               std::string("tzc-bench ") + argv[0]);
  Crowd crowd;
  bool full = false;
  std::string json;
  add_options(app, crowd, full, json);
  if (const auto over = command_line::parse(app, argc, argv)) return *over;
  print_header();
  std::vector<CrowdRow> rows;
  for (const Crowd& one : full ? full_crowds() : std::vector<Crowd>{crowd})
    if (!measure(one, rows)) return 1;
  if (json.empty()) return 0;
  auto as_json = nlohmann::json::array();
  for (const CrowdRow& row : rows) as_json.push_back(to_json(row));
  return write_rows(json, std::move(as_json)) ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
