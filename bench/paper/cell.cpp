// SPDX-License-Identifier: BSD-3-Clause
#include "paper/cell.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace tzc {
namespace bench {
namespace {

constexpr double enough_of_the_rate = 0.95;

double moved_bytes(const Cost& cost) {
  return static_cast<double>(cost.sent_bytes + cost.received_bytes + cost.copied_bytes);
}

void add(const Measurement& round, Summary& summary, std::vector<double>& latencies_us) {
  summary.sent += round.latency_ns.front().size();
  for (std::size_t who = 0; who < round.latency_ns.size(); ++who) {
    for (const std::uint64_t ns : round.latency_ns[who]) {
      if (ns == 0) continue;
      ++summary.delivered[who];
      latencies_us.push_back(static_cast<double>(ns) / 1000.0);
    }
  }
  summary.publisher += round.publisher;
  summary.subscribers += round.subscribers;
}

}  // namespace

Summary summarize(const CellResult& result, double wanted_rate) {
  Summary summary{result.cell, 0, false, 0, {}, std::nullopt, {}, {}};
  summary.delivered.resize(result.cell.subscribers);
  std::vector<double> latencies_us;
  double seconds = 0;
  for (const auto& [number, round] : result.rounds) {
    add(round, summary, latencies_us);
    seconds += round.seconds;
  }
  summary.rate = seconds > 0 ? static_cast<double>(summary.sent) / seconds : 0;
  summary.holds_rate = summary.rate >= enough_of_the_rate * wanted_rate;
  summary.latency_us = spread_of(std::move(latencies_us));
  return summary;
}

double worst_share(const Summary& summary) {
  const auto worst = std::min_element(summary.delivered.begin(), summary.delivered.end());
  return summary.sent > 0 ? static_cast<double>(*worst) / static_cast<double>(summary.sent) : 0;
}

double mean_share(const Summary& summary) {
  const std::size_t all = std::accumulate(summary.delivered.begin(), summary.delivered.end(), std::size_t{0});
  const std::size_t expected = summary.sent * summary.delivered.size();
  return expected > 0 ? static_cast<double>(all) / static_cast<double>(expected) : 0;
}

bool in_full(const Summary& summary) {
  return summary.holds_rate && worst_share(summary) == 1;
}

double copies_per_message(const Summary& summary) {
  const double bytes = static_cast<double>(summary.sent) * static_cast<double>(summary.cell.size_bytes);
  return bytes > 0 ? (moved_bytes(summary.publisher) + moved_bytes(summary.subscribers)) / bytes : 0;
}

std::string size_text(std::size_t bytes) {
  if (bytes < 1024) return fmt::format("{} B", bytes);
  const bool large = bytes >= 1024 * 1024;
  return fmt::format("{:.4g} {}", static_cast<double>(bytes) / (large ? 1024.0 * 1024 : 1024.0),
                     large ? "MB" : "KB");
}

}  // namespace bench
}  // namespace tzc
