// SPDX-License-Identifier: BSD-3-Clause
#include "paper/daemons.h"

#include <algorithm>
#include <map>

#include "core/contenders.h"
#include "roscpp/roscore.h"

namespace tzc {
namespace bench {
namespace {

bool any_of(const std::vector<Cell>& cells, const Contender& contender) {
  return std::any_of(cells.begin(), cells.end(),
                     [&](const Cell& cell) { return cell.contender == contender.name(); });
}

void remove_cells(std::vector<Cell>& cells, const Contender& contender) {
  const auto out = std::remove_if(cells.begin(), cells.end(),
                                  [&](const Cell& cell) { return cell.contender == contender.name(); });
  cells.erase(out, cells.end());
}

}  // namespace

Daemons::Daemons(const Contenders& contenders, std::vector<Cell>& cells, std::vector<std::string>& said) {
  std::map<Daemon, std::string> daemons{{Daemon::none, ""}};  // why it does not run; empty: it does
  std::map<std::string, std::string> left_out;                // by reason
  for (const auto& contender : contenders) {
    if (!any_of(cells, *contender)) continue;
    const auto known = daemons.find(contender->needs());
    std::string why =
        known != daemons.end() ? known->second : daemons[contender->needs()] = start(contender->needs());
    if (why.empty()) why = contender->obstacle();
    if (why.empty()) continue;
    std::string& names = left_out[why];
    names += (names.empty() ? "" : ", ") + std::string(contender->name());
    remove_cells(cells, *contender);
  }
  for (const auto& [why, names] : left_out) said.push_back(why + "; left out: " + names);
}

std::string Daemons::start([[maybe_unused]] Daemon daemon) {
#ifdef TZC_BENCH_ROSCPP
  if (daemon == Daemon::rosmaster) {
    const auto core = std::make_shared<RosCore>();
    running_.push_back(core);
    return core->running() ? ""
                           : "rosmaster does not start: is ROS's environment set up (source setup.bash)?";
  }
#endif
#ifdef TZC_BENCH_ICEORYX
  if (daemon == Daemon::roudi) {
    const auto roudi = std::make_shared<RouDi>();
    running_.push_back(roudi);
    return roudi->running() ? ""
                            : "iox-roudi does not start: another one runs, or its package iceoryx is missing";
  }
#endif
  return "";
}

}  // namespace bench
}  // namespace tzc
