// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

#include "model.h"

namespace tzc::monitor {

/// Latencies of a bucket are below this, in microseconds.
double bucket_end_us(std::size_t bucket);
std::uint64_t count(const Latencies& latencies);
/// A latency that this share of the messages did not exceed, in seconds: the end of its bucket. 0 without any message.
double quantile_s(const Latencies& latencies, double share);

}  // namespace tzc::monitor
