// SPDX-License-Identifier: BSD-3-Clause
// usage: protocol_model
// Explores every interleaving of the lifetime protocol in each scenario; then plants each mistake and demands
// that the exploration finds it.
#include <cstdio>

#include "protocol_programs.h"

namespace tzc {
namespace model {
namespace {

//                               name                           messages blocks queue best_effort twice deaths
constexpr Scenario scenarios[] = {
    {"medium_effort", 3, 1, 2, false, false, 0, Mistake::none},
    {"medium_effort, one dies", 2, 1, 2, false, false, 1, Mistake::none},
    {"best_effort, queue of one", 3, 1, 1, true, false, 0, Mistake::none},
    {"best_effort, one dies", 2, 1, 1, true, false, 1, Mistake::none},
    {"two blocks in each message", 2, 2, 1, true, false, 1, Mistake::none},
    {"each message sent twice", 2, 1, 2, false, true, 0, Mistake::none},
};

struct Planted {
  Mistake mistake;
  const char* name;
};

constexpr Planted mistakes[] = {
    {Mistake::mark_after_send, "marking a block after the record is sent"},
    {Mistake::check_before_take, "checking the verdict before taking instead of in one step"},
    {Mistake::forget_taken_on_revoke, "revoking a range without asking who won its beginning"},
    {Mistake::reuse_taken_blocks, "reusing blocks that are taken"},
    {Mistake::ignore_generation, "releasing without the right generation"},
};

bool explore(const Scenario& which, bool print) {
  scenario = which;
  ProtocolExplorer explorer;
  explorer.programs = {subscribe_round, subscribe_round, publish_round};
  explorer.writer = publisher;
  explorer.most_deaths = which.deaths;
  explorer.on_death = hang_up;
  explorer.check_end = check_end;
  const bool holds = explorer.explore(ProtocolExplorer::State{});
  if (print)
    std::printf("%-32s %9zu states  %s\n", which.name, explorer.states(),
                holds ? "holds" : explorer.violation().c_str());
  if (print && !holds) std::printf("  %s\n", explorer.trace().c_str());
  std::fflush(stdout);
  return holds;
}

bool is_found(const Planted& planted) {
  for (Scenario broken : scenarios) {
    broken.mistake = planted.mistake;
    if (explore(broken, false)) continue;
    std::printf("planted: %s: found in \"%s\"\n", planted.name, broken.name);
    return true;
  }
  std::printf("planted: %s: NOT FOUND\n", planted.name);
  return false;
}

int run() {
  int failures = 0;
  for (const Scenario& each : scenarios) failures += explore(each, true) ? 0 : 1;
  for (const Planted& each : mistakes) failures += is_found(each) ? 0 : 1;
  return failures;
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
