// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "paper/cell.h"
#include "paper/store.h"
#include "paper/tables.h"

namespace tzc {
namespace bench {

/// What a control loop wants to know of a cell that was measured in real time; times in microseconds.
struct RealTimeFigures {
  Cell cell;
  std::size_t sent = 0;                  // messages
  std::vector<std::size_t> delivered;    // by subscriber
  std::vector<double> latencies_us;      // of every delivery, sorted
  std::vector<double> period_errors_us;  // how far the time between two deliveries is from the period, sorted
  double allocations = 0, page_faults = 0;  // of one message, in all processes together
};

/// Of cells that were measured in real time; the others are left out.
std::vector<RealTimeFigures> real_time_figures(const std::vector<CellResult>& results, double rate);

/// One row a cell: messages sent, the share of the subscriber that got fewest, as in overview_table; median, 99 %, 99.9 % and
/// worst of latency and of the period's error.
Table real_time_table(const std::vector<RealTimeFigures>& figures);

/// gnuplot's input that draws how many deliveries took how long, and how far periods were off; empty: nothing arrived.
/// The output is real-time.svg.tmp and real-time.png.tmp.
std::string real_time_script(const std::vector<RealTimeFigures>& figures);

}  // namespace bench
}  // namespace tzc
