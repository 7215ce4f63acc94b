// SPDX-License-Identifier: BSD-3-Clause
#include "latency.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "words.h"

namespace tzc::monitor {
namespace {

constexpr double unit_us = 1.024;

double power_us(std::size_t bucket) {
  return std::ldexp(unit_us, static_cast<int>(bucket));
}

/// Of some messages.
std::string quantile_words(const Latencies& latencies, double share) {
  const double end = quantile_s(latencies, share);
  return std::isinf(end) ? "> " + short_time(power_us(latencies.size() - 2) * 1e-6) : "< " + short_time(end);
}

}  // namespace

double bucket_end_us(std::size_t bucket) {
  return bucket + 1 < Latencies().size() ? power_us(bucket) : std::numeric_limits<double>::infinity();
}

std::uint64_t count(const Latencies& latencies) {
  return std::accumulate(latencies.begin(), latencies.end(), std::uint64_t{0});
}

double quantile_s(const Latencies& latencies, double share) {
  const double wanted = share * static_cast<double>(count(latencies));
  double seen = 0;
  for (std::size_t i = 0; wanted > 0 && i < latencies.size(); ++i) {
    seen += static_cast<double>(latencies[i]);
    if (seen >= wanted) return bucket_end_us(i) * 1e-6;
  }
  return 0;
}

std::string latency_words(const Latencies& latencies) {
  if (count(latencies) == 0) return "-";
  return fmt::format("{} (99%: {})", quantile_words(latencies, 0.5), quantile_words(latencies, 0.99));
}

}  // namespace tzc::monitor
