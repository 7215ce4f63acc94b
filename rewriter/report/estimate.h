// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/output.h"

namespace tzc::rewriter {

/// Copies of a message's data on its way to one subscriber in another process over TCPROS: serialised, into the
/// kernel, out of it, de-serialised.
constexpr unsigned tcpros_copies = 4;

/// What the port changes at a publish site, for each message and each such subscriber.
struct SiteEstimate {
  const Site* site;
  std::optional<std::uint64_t>
      size;               ///< bytes of the largest message measured, or usual for the type; none: unknown
  bool measured = false;  ///< in a recording
  unsigned before = 0, after = 0;  ///< copies of the data
};

/// The publish sites of messages with data, in the order of the report.
std::vector<SiteEstimate> estimates(const PackageReport& package);

/// One message of each site.
struct EstimateSum {
  unsigned sites = 0, before = 0, after = 0;
  unsigned left = 0;                                ///< sites that stay on TCPROS
  std::uint64_t bytes_before = 0, bytes_after = 0;  ///< that the copies move, where sizes are known
  unsigned measured = 0, usual = 0;                 ///< sites by what their size is known from
};
EstimateSum sum_of(const std::vector<SiteEstimate>& all);

/// "6.2 MB"
std::string in_bytes(double bytes);
/// One line for a terminal; empty: nothing is published that has data.
std::string text_estimate(const PackageReport& package);

}  // namespace tzc::rewriter
