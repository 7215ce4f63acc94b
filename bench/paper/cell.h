// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measure.h"
#include "paper/conditions.h"
#include "paper/statistics.h"

namespace tzc {
namespace bench {

/// One case of the evaluation: a contender, a message size, a number of subscribers, and what is special about it.
struct Cell {
  std::string contender;
  std::size_t size_bytes;
  std::size_t subscribers;
  Conditions conditions{};
};

/// What has been measured of a cell, by round. Only complete measurements.
struct CellResult {
  Cell cell;
  std::map<std::size_t, Measurement> rounds;
};

/// What the tables and plots show of a cell.
struct Summary {
  Cell cell;
  double rate;                         // messages per second that the publisher reached
  bool holds_rate;                     // at least 95 % of what was asked for
  std::size_t sent;                    // messages
  std::vector<std::size_t> delivered;  // by subscriber
  std::optional<Spread> latency_us;    // of every delivery; nothing: there was none
  Cost publisher;                      // over all messages
  Cost subscribers;
};

Summary summarize(const CellResult& result, double wanted_rate);

/// Of the subscriber that got fewest; 0 to 1.
double worst_share(const Summary& summary);
double mean_share(const Summary& summary);
/// Every message was delivered, at the rate that was wanted: only then do latencies tell all.
bool in_full(const Summary& summary);
/// How often a message was copied: by memcpy and memmove, into sockets, out of sockets; by all processes together.
double copies_per_message(const Summary& summary);

/// "4 KB", "1.5 MB", "100 B".
std::string size_text(std::size_t bytes);

}  // namespace bench
}  // namespace tzc
