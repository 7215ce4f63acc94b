// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "solve/solution.h"

namespace tzc::rewriter {

/// A site as far as the facts know it, without a level.
Site described(const Advertise& site, SiteKind kind, const std::string& package_dir);
Site described(const Publish& site, SiteKind kind, const std::string& package_dir);
Site described(const Subscribe& site, SiteKind kind, const std::string& package_dir);

/// The topic of a publisher that is advertised once.
std::optional<std::string> topic_of(const Facts& facts, const Neighbours& neighbours, const Key& publisher);

/// Every site of the package, each exactly once, with its level. Notes in `solution` which subscriptions are
/// ported.
std::vector<Site> decided_sites(const Facts& facts, const Components& components,
                                const EngineOptions& options, const Demotions& demotions, Solution& solution);

/// The bytes to reserve for a publisher, and the sentence that explains them.
struct MemorySize {
  std::string text;
  std::string note;
};
MemorySize memory_size(const Advertise& site, const EngineOptions& options);

}  // namespace tzc::rewriter
