// SPDX-License-Identifier: BSD-3-Clause
#include "report/html_estimate.h"

#include <fmt/format.h>

#include "report/estimate.h"
#include "report/html_diff.h"

namespace tzc::rewriter {
namespace {

std::string amount(unsigned copies, const std::optional<std::uint64_t>& size) {
  if (copies == 0) return "0";
  return size ? in_bytes(static_cast<double>(*size) * copies) : fmt::format("{} &times; its size", copies);
}

std::string size_of(const SiteEstimate& estimate) {
  if (!estimate.size) return "<span class=\"none\">not measured</span>";
  const std::string size = in_bytes(static_cast<double>(*estimate.size));
  return estimate.measured ? size : "<span class=\"none\" title=\"usual for the type\">" + size + "</span>";
}

const char* class_of(unsigned copies) {
  return copies == 0 ? "good" : copies == tcpros_copies ? "bad" : "fair";
}

std::string row(const Report& report, const SiteEstimate& estimate) {
  const Site& site = *estimate.site;
  const std::string topic = site.topic ? "<code>" + html_escaped(*site.topic) + "</code>"
                                       : "<span class=\"none\">not a constant</span>";
  return fmt::format(
      "<tr><td><code>{}:{}</code></td><td>{}</td><td><code>{}</code></td><td class=\"num\">{}</td>"
      "<td class=\"num\">{}</td><td class=\"num {}\">{}</td><td class=\"num\">{}</td><td class=\"num "
      "{}\">{}</td></tr>\n",
      html_escaped(relative_file(report, site.where.file)), site.where.line, topic,
      html_escaped(site.message_type), size_of(estimate), estimate.before, class_of(estimate.after),
      estimate.after, amount(estimate.before, estimate.size), class_of(estimate.after),
      amount(estimate.after, estimate.size));
}

}  // namespace

std::string copies(unsigned n) {
  return fmt::format("{} cop{}", n, n == 1 ? "y" : "ies");
}

std::string html_estimate(const PackageReport& package) {
  const std::vector<SiteEstimate> all = estimates(package);
  if (all.empty()) return "";
  const EstimateSum sum = sum_of(all);
  std::string html = fmt::format(
      "<h3>What the port buys</h3>\n<p>An estimate, for each message and each subscriber in another process: "
      "over TCPROS the "
      "data are copied {} times (serialised, into the kernel, out of it, de-serialised), in shared memory "
      "not at all, or once at "
      "<code>one_copy</code>. One message of each site: {} now, {} after the port{}. A callback that may "
      "write adds one.{}</p>\n",
      tcpros_copies, copies(sum.before), copies(sum.after),
      sum.left == 0 ? ""
                    : fmt::format(", {} of them at the {} that stay{} on TCPROS", sum.left * tcpros_copies,
                                  sum.left == 1 ? "site" : "sites", sum.left == 1 ? "s" : ""),
      package.message_sizes.empty()
          ? " Sizes in grey are usual for the type; <code>--bag</code> measures them."
          : "");
  html +=
      "<table class=\"sites estimate\"><thead><tr><th>published at</th><th>topic</th><th>message</th><th "
      "class=\"num\">size</th>"
      "<th class=\"num\">copies now</th><th class=\"num\">after</th><th class=\"num\">copied now</th><th "
      "class=\"num\">after</th></tr></thead>\n<tbody>\n";
  for (const SiteEstimate& estimate : all) html += row(package.report, estimate);
  return html + "</tbody></table>\n";
}

}  // namespace tzc::rewriter
