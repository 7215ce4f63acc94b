// SPDX-License-Identifier: BSD-3-Clause
#include "report/estimate.h"

namespace tzc::rewriter {
namespace {

unsigned copies_at(Level level) {
  if (level == Level::zero_copy) return 0;
  return level == Level::one_copy ? 1 : tcpros_copies;
}

}  // namespace

std::vector<SiteEstimate> estimates(const PackageReport& package) {
  std::vector<SiteEstimate> all;
  for (const Site& site : package.report.sites) {
    if (site.kind != SiteKind::publish || site.level == Level::not_needed) continue;
    SiteEstimate estimate{&site, {}, tcpros_copies, copies_at(site.level)};
    if (!site.pending) estimate.before = estimate.after;  // ported already, or left
    const auto size = package.message_sizes.find(site.topic.value_or(""));
    if (site.topic && size != package.message_sizes.end()) estimate.size = size->second;
    all.push_back(estimate);
  }
  return all;
}

EstimateSum sum_of(const std::vector<SiteEstimate>& all) {
  EstimateSum sum;
  for (const SiteEstimate& estimate : all) {
    ++sum.sites;
    sum.before += estimate.before;
    sum.after += estimate.after;
    sum.left += estimate.after == tcpros_copies;
  }
  return sum;
}

}  // namespace tzc::rewriter
