// SPDX-License-Identifier: BSD-3-Clause
#include "report/estimate.h"

#include <fmt/format.h>

#include <map>

namespace tzc::rewriter {
namespace {

unsigned copies_at(Level level) {
  if (level == Level::zero_copy) return 0;
  return level == Level::one_copy ? 1 : tcpros_copies;
}

/// What a usual sensor or map makes; docs/tzc-rewrite.md lists them.
std::optional<std::uint64_t> usual_size(const std::string& type) {
  static const std::map<std::string, std::uint64_t> sizes = {
      {"nav_msgs/OccupancyGrid", 1000 * 1000},       {"sensor_msgs/CompressedImage", 60 * 1000},
      {"sensor_msgs/Image", 640 * 480 * 3},          {"sensor_msgs/LaserScan", 720 * (4 + 4)},
      {"sensor_msgs/PointCloud", 30 * 1000 * 12},    {"sensor_msgs/PointCloud2", 30 * 1000 * 16},
      {"stereo_msgs/DisparityImage", 640 * 480 * 4},
  };
  const auto found = sizes.find(type);
  return found == sizes.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::vector<SiteEstimate> estimates(const PackageReport& package) {
  std::vector<SiteEstimate> all;
  for (const Site& site : package.report.sites) {
    if (site.kind != SiteKind::publish || site.level == Level::not_needed) continue;
    SiteEstimate estimate{&site, usual_size(site.message_type), false, tcpros_copies, copies_at(site.level)};
    if (!site.pending) estimate.before = estimate.after;  // ported already, or left
    const auto size = package.message_sizes.find(site.topic.value_or(""));
    estimate.measured = site.topic && size != package.message_sizes.end();
    if (estimate.measured) estimate.size = size->second;
    all.push_back(estimate);
  }
  return all;
}

EstimateSum sum_of(const std::vector<SiteEstimate>& all) {
  EstimateSum sum;
  unsigned unknown = 0;
  for (const SiteEstimate& estimate : all) {
    ++sum.sites;
    sum.before += estimate.before;
    sum.after += estimate.after;
    sum.left += estimate.after == tcpros_copies;
    sum.bytes_before += estimate.size.value_or(0) * estimate.before;
    sum.bytes_after += estimate.size.value_or(0) * estimate.after;
    ++(estimate.measured ? sum.measured : estimate.size ? sum.usual : unknown);
  }
  return sum;
}

std::string in_bytes(double bytes) {
  const char* const units[] = {"B", "KB", "MB", "GB"};
  unsigned unit = 0;
  for (; bytes >= 1000 && unit < 3; ++unit) bytes /= 1000;
  return unit == 0 || bytes >= 100 ? fmt::format("{:.0f} {}", bytes, units[unit])
                                   : fmt::format("{:.1f} {}", bytes, units[unit]);
}

std::string text_estimate(const PackageReport& package) {
  const EstimateSum sum = sum_of(estimates(package));
  if (sum.sites == 0) return "";
  std::string text = fmt::format("{} copies now, {} after", sum.before, sum.after);
  const unsigned known = sum.measured + sum.usual;
  if (known > 0)
    text += fmt::format("; {} now, {} after ({})", in_bytes(static_cast<double>(sum.bytes_before)),
                        in_bytes(static_cast<double>(sum.bytes_after)),
                        sum.usual == 0      ? "measured"
                        : sum.measured == 0 ? "usual sizes"
                                            : "measured and usual sizes");
  return text + (known > 0 && known < sum.sites
                     ? fmt::format(", {} of unknown size not counted", sum.sites - known)
                     : "");
}

}  // namespace tzc::rewriter
