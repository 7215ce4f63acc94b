// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>

#include "pairing/recording.h"

namespace tzc::compare {

/// When a message with this stamp was first received from the input, both in nanoseconds; empty without
/// input.
using InputTimes = std::map<std::int64_t, std::int64_t>;

struct Latency {
  double median_us = 0, p99_us = 0;
  std::size_t messages = 0;
};

/// How long a stream's messages took: from the input message with the same stamp to the output; without input
/// from the header's stamp, where that is a time of this run. 0 when the recorder received the output first.
/// Null when both are unknown.
std::optional<Latency> latency_of(const Stream& stream, const InputTimes& inputs);

}  // namespace tzc::compare
