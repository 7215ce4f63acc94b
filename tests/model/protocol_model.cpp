// SPDX-License-Identifier: BSD-3-Clause
// usage: protocol_model
// Explores every interleaving of the lifetime protocol in each scenario; then plants each mistake and demands
// that the exploration finds it.
#include "exploration.h"
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
    {"no revocation for long", 3, 1, 2, false, false, 0, Mistake::none, Behind::revoked},
    {"nothing taken for long", 3, 1, 1, true, false, 0, Mistake::none, Behind::taken},
};

constexpr Planted<Mistake> mistakes[] = {
    {Mistake::mark_after_send, "marking a block after the record is sent"},
    {Mistake::check_before_take, "checking the verdict before taking instead of in one step"},
    {Mistake::forget_taken_on_revoke, "revoking a range without asking who won its beginning"},
    {Mistake::reuse_taken_blocks, "reusing blocks that are taken"},
    {Mistake::ignore_generation, "releasing without the right generation"},
    {Mistake::never_follow, "leaving a cursor 2^31 records behind"},
};

int run() {
  ProtocolExplorer explorer;
  explorer.programs = {subscribe_round, subscribe_round, publish_round};
  explorer.writer = publisher;
  explorer.on_death = hang_up;
  explorer.check_end = check_end;
  return Exploration<Scenario, ProtocolExplorer>(explorer, scenario)
      .starts_with(start_of)
      .explore(scenarios, mistakes);
}

}  // namespace
}  // namespace model
}  // namespace tzc

int main() {
  return tzc::model::run();
}
