// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "paper/cell.h"

namespace tzc::test {

/// A measurement that took a second for each ten messages. latency_ns: [subscriber][message].
inline bench::Measurement made_up(std::vector<std::vector<std::uint64_t>> latency_ns) {
  bench::Measurement round;
  round.outcome = bench::Outcome::complete;
  round.seconds = static_cast<double>(latency_ns.front().size()) / 10;
  round.publisher = {100, 200, 300, 4};
  round.subscribers = {10, 20, 30, 40};
  round.latency_ns = std::move(latency_ns);
  return round;
}

}  // namespace tzc::test
