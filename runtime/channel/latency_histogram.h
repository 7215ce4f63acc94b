// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

namespace tzc {
namespace channel {

constexpr std::size_t latency_buckets = 24;
/// Bucket i counts latencies below 2^i units of 1024 ns and not in one before it; the last one, all longer ones, too.
using LatencyCounts = std::array<std::uint64_t, latency_buckets>;

/// The bucket of a latency in units of 1024 ns. Pure.
constexpr std::size_t latency_bucket(std::uint32_t latency) {
  std::size_t bucket = 0;
  while (bucket + 1 < latency_buckets && latency >> bucket != 0) ++bucket;
  return bucket;
}

/// Counts the time from the making of a record until it is taken. One thread adds; others may read.
class LatencyHistogram {
 public:
  void add(std::uint32_t latency) noexcept {
    std::atomic<std::uint64_t>& count = counts_[latency_bucket(latency)];
    count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  LatencyCounts counts() const {
    LatencyCounts copy{};
    for (std::size_t i = 0; i < latency_buckets; ++i) copy[i] = counts_[i].load(std::memory_order_relaxed);
    return copy;
  }

 private:
  std::array<std::atomic<std::uint64_t>, latency_buckets> counts_{};
};

}  // namespace channel
}  // namespace tzc
