// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "model.h"

namespace tzc::monitor {

/// Latencies of a bucket are below this, in microseconds. The last bucket has all longer ones, too: infinity.
double bucket_end_us(std::size_t bucket);
std::uint64_t count(const Latencies& latencies);
/// A latency that this share of the messages did not exceed, in seconds: the end of its bucket. 0 without any message.
double quantile_s(const Latencies& latencies, double share);
/// What half of the messages and 99 % of them did not exceed: "< 66 us (99%: < 262 us)"; of the last bucket "> 4.3 s"; "-"
/// without any message.
std::string latency_words(const Latencies& latencies);

}  // namespace tzc::monitor
