// SPDX-License-Identifier: BSD-3-Clause
#include "paper/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <utility>

namespace tzc {
namespace bench {
namespace {

constexpr std::size_t small_bytes = 4 << 10, large_bytes = 4 << 20;  // the paper compares these

using Group = std::vector<const Summary*>;

std::vector<std::pair<std::string, Group>> by_contender(const std::vector<Summary>& summaries) {
  std::vector<std::pair<std::string, Group>> groups;
  for (const Summary& summary : summaries) {
    const auto same = std::find_if(groups.begin(), groups.end(),
                                   [&](const auto& group) { return group.first == summary.cell.contender; });
    if (same != groups.end())
      same->second.push_back(&summary);
    else
      groups.push_back({summary.cell.contender, {&summary}});
  }
  return groups;
}

double most(const Group& group, const std::function<double(const Summary&)>& value) {
  double result = 0;
  for (const Summary* summary : group) result = std::max(result, value(*summary));
  return result;
}

double least_share(const Group& group) {
  return 1 - most(group, [](const Summary& summary) { return 1 - worst_share(summary); });
}

/// How much longer 4 MB take than 4 KB, where that is most; empty: it was not measured.
std::string growth(const Group& group) {
  std::map<std::size_t, double> small, large;  // medians, by subscribers
  for (const Summary* summary : group) {
    const Cell& cell = summary->cell;
    if (!summary->latency_us) continue;
    if (cell.size_bytes == small_bytes) small[cell.subscribers] = summary->latency_us->median;
    if (cell.size_bytes == large_bytes) large[cell.subscribers] = summary->latency_us->median;
  }
  double result = 0;
  for (const auto& [subscribers, median] : small)
    if (large.count(subscribers) > 0) result = std::max(result, large[subscribers] / median);
  return result > 0 ? fmt::format("{:.2f}", result) : "";
}

double median_of(const Summary& summary) {
  return summary.latency_us ? summary.latency_us->median : 0;
}

double p99_of(const Summary& summary) {
  return summary.latency_us ? summary.latency_us->p99 : 0;
}

std::string ranked(Group group) {
  std::stable_sort(group.begin(), group.end(),
                   [](const Summary* a, const Summary* b) { return median_of(*a) < median_of(*b); });
  std::string text;
  for (const Summary* summary : group)
    text += fmt::format("{}{} {:.1f}{}", text.empty() ? "" : ", ", summary->cell.contender,
                        median_of(*summary), in_full(*summary) ? "" : "*");
  return text;
}

}  // namespace

Table overview_table(const std::vector<Summary>& summaries) {
  Table table{{"contender", "cells", "cells_at_rate", "least_delivered_share", "largest_median_us",
               "largest_p99_us", "4mb_by_4kb"},
              {}};
  for (const auto& [name, group] : by_contender(summaries)) {
    const auto at_rate =
        std::count_if(group.begin(), group.end(), [](const Summary* one) { return one->holds_rate; });
    table.rows.push_back({name, std::to_string(group.size()), std::to_string(at_rate),
                          fmt::format("{:.6f}", least_share(group)),
                          fmt::format("{:.1f}", most(group, median_of)),
                          fmt::format("{:.1f}", most(group, p99_of)), growth(group)});
  }
  return table;
}

Table ranking_table(const std::vector<Summary>& summaries) {
  std::map<std::pair<std::size_t, std::size_t>, Group> cases;
  for (const Summary& summary : summaries)
    if (summary.latency_us) cases[{summary.cell.size_bytes, summary.cell.subscribers}].push_back(&summary);
  Table table{{"size_bytes", "subscribers", "median_us"}, {}};
  for (const auto& [key, group] : cases)
    table.rows.push_back({std::to_string(key.first), std::to_string(key.second), ranked(group)});
  return table;
}

}  // namespace bench
}  // namespace tzc
