// SPDX-License-Identifier: BSD-3-Clause
#include "engine/latency.h"

#include <algorithm>
#include <cstdlib>

namespace tzc::compare {
namespace {

constexpr std::int64_t longest_ns = 60'000'000'000;  // beyond that a stamp is not the time of publishing

std::optional<std::int64_t> latency_of(const MessageFacts& message, const InputTimes& inputs) {
  if (!message.header || message.header->nanoseconds == 0) return std::nullopt;
  std::int64_t start = message.header->nanoseconds;
  if (!inputs.empty()) {
    const auto input = inputs.find(start);
    if (input == inputs.end()) return std::nullopt;
    start = input->second;
  }
  const std::int64_t latency = message.received_ns - start;
  if (std::abs(latency) > longest_ns) return std::nullopt;
  // The recorder may receive the input after a quick node's output, because they use different sockets.
  return std::max<std::int64_t>(latency, 0);
}

}  // namespace

std::optional<Latency> latency_of(const Stream& stream, const InputTimes& inputs) {
  std::vector<std::int64_t> all;
  for (const MessageFacts& message : stream.messages) {
    if (const auto latency = latency_of(message, inputs)) all.push_back(*latency);
  }
  if (all.empty()) return std::nullopt;
  std::sort(all.begin(), all.end());
  const auto us = [&](std::size_t index) { return static_cast<double>(all[index]) / 1000; };
  return Latency{us(all.size() / 2), us(all.size() * 99 / 100), all.size()};
}

}  // namespace tzc::compare
