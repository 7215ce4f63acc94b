// SPDX-License-Identifier: BSD-3-Clause
// Nodes that live for hours beside others that are killed, stopped and replaced: is each message what was published, and does
// what the processes have stay what it was?
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "command_line/arguments.h"
#include "commands.h"
#include "environment.h"
#include "options.h"
#include "processes.h"
#include "report.h"
#include "roscpp/roscore.h"
#include "roscpp/soak.h"
#include "steadiness.h"

namespace tzc {
namespace bench {
namespace {

constexpr char examples[] = R"(
Examples:
  tzc-bench soak                               an hour
  tzc-bench soak --minutes 1440 --json day.json
Runs a ROS master of its own. SIGINT, SIGTERM or SIGHUP ends it early, with the table of what has been until then.
Exit status: 0: no message was spoiled, no process ended by itself, nothing grew; 1 otherwise; 2: a mistake on the command
line. What grows is judged from 10 minutes on: before, processes are still warming up. It grew if that is more than 1 % and what
the plain subscriber grew by, which has nothing of TZC.)";

constexpr double judged_from_minutes = 10;
using Quantity = std::size_t Needs::*;
struct NamedQuantity {
  const char* name;
  Quantity quantity;
};
constexpr NamedQuantity quantities[] = {{"threads", &Needs::threads},
                                        {"descriptors", &Needs::descriptors},
                                        {"private_kb", &Needs::private_kb},
                                        {"shared_kb", &Needs::shared_kb}};

Trend trend_in(const SoakProcess& process, Quantity quantity) {
  std::vector<std::size_t> all;
  for (const Needs& look : process.looks) all.push_back(look.*quantity);
  return trend_of(all);
}

/// What a subscriber grew by that has nothing of TZC: roscpp keeps a connection for ever that broke before it was made, as to
/// publishers that were killed.
std::size_t control_growth(const std::vector<SoakProcess>& processes, Quantity quantity) {
  for (const SoakProcess& process : processes)
    if (process.role->is_control) return trend_in(process, quantity).growth();
  return 0;
}

bool grew(const std::vector<SoakProcess>& processes, const SoakProcess& process, Quantity quantity) {
  return !process.role->is_control && trend_in(process, quantity).grew(control_growth(processes, quantity));
}

void print_counts(const std::vector<SoakProcess>& processes) {
  std::printf("%-18s %12s %12s %9s %9s\n", "process", "published", "received", "spoiled", "killed");
  for (const SoakProcess& process : processes)
    std::printf("%-18s %12llu %12llu %9llu %9zu\n", process.role->name,
                static_cast<unsigned long long>(process.counts->published),
                static_cast<unsigned long long>(process.counts->received),
                static_cast<unsigned long long>(process.counts->spoiled), process.killed);
}

void print_trends(const std::vector<SoakProcess>& processes, bool judged) {
  std::printf("\n%-18s %-12s %21s %21s\n", "process", "", "second quarter", "last quarter");
  for (const SoakProcess& process : processes) {
    if (!process.watched()) continue;
    for (const NamedQuantity& one : quantities) {
      const Trend trend = trend_in(process, one.quantity);
      std::printf("%-18s %-12s %10zu..%-9zu %10zu..%-9zu%s\n", process.role->name, one.name,
                  trend.early.least, trend.early.most, trend.late.least, trend.late.most,
                  judged && grew(processes, process, one.quantity) ? "  GREW" : "");
    }
  }
  if (!judged) std::printf("Too short to judge what grows: --minutes %g or more.\n", judged_from_minutes);
}

nlohmann::json to_json(const SoakProcess& process) {
  auto looks = nlohmann::json::array();
  for (const Needs& look : process.looks) {
    nlohmann::json values;
    for (const NamedQuantity& one : quantities) values[one.name] = look.*one.quantity;
    looks.push_back(std::move(values));
  }
  return {{"process", process.role->name},
          {"published", process.counts->published.load()},
          {"received", process.counts->received.load()},
          {"spoiled", process.counts->spoiled.load()},
          {"killed", process.killed},
          {"looks", std::move(looks)}};
}

nlohmann::json to_json(const std::vector<SoakProcess>& processes) {
  auto rows = nlohmann::json::array();
  for (const SoakProcess& process : processes) rows.push_back(to_json(process));
  return rows;
}

bool all_well(const std::vector<SoakProcess>& processes, bool judged) {
  for (const SoakProcess& process : processes) {
    if (process.counts->spoiled != 0) return false;
    for (const NamedQuantity& one : quantities)
      if (judged && process.watched() && grew(processes, process, one.quantity)) return false;
  }
  return true;
}

void add_options(CLI::App& app, SoakPlan& plan, std::string& json) {
  app.footer(examples);
  app.add_option("--minutes", plan.minutes, "how long")
      ->check(command_line::number_between(0.001, 1e5))
      ->capture_default_str();
  app.add_option("--look-every", plan.look_every_s, "seconds between two looks at all processes")
      ->check(command_line::number_between(0.001, 1e5))
      ->capture_default_str();
  app.add_option("--kill-every", plan.kill_every_s, "seconds that a process lives that is to be killed")
      ->check(command_line::number_between(0.001, 1e5))
      ->capture_default_str();
  app.add_option("--stop-for", plan.stop_for_s, "seconds that the stopped process stands, and goes on")
      ->check(command_line::number_between(0.001, 1e5))
      ->capture_default_str();
  app.add_option("--json", json, "write counts and looks to this file")->check(command_line::file_to_write());
  add_keep_settings(app);
}

}  // namespace

int run_soak(int argc, char** argv) {
  CLI::App app("Nodes for hours, beside others that are killed, stopped and replaced.",
               std::string("tzc-bench ") + argv[0]);
  SoakPlan plan;
  std::string json;
  add_options(app, plan, json);
  if (const auto over = command_line::parse(app, argc, argv)) return *over;
  const RosCore core;
  if (!core.running()) {
    std::fprintf(stderr, "rosmaster does not start: is ROS's environment set up (source setup.bash)?\n");
    return 1;
  }
  hold_interrupts();
  Soak soak(plan);
  const bool lasted = soak.run();
  const bool judged = soak.seconds() >= judged_from_minutes * 60;
  print_counts(soak.processes());
  print_trends(soak.processes(), judged);
  const bool written = json.empty() || write_rows(json, to_json(soak.processes()));
  return lasted && written && all_well(soak.processes(), judged) ? 0 : 1;
}

}  // namespace bench
}  // namespace tzc
