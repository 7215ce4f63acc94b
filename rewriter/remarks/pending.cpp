// SPDX-License-Identifier: BSD-3-Clause
#include "remarks/pending.h"

#include "model/codes.h"

namespace tzc::rewriter {
namespace {

PendingPlace of_site(const Site& site) {
  return {codes::TZC5001, site.where,
          std::string(name_of(site.kind)) + " of " + site.message_type + " can be " + name_of(site.level) +
              " and is not ported yet: tzc-rewrite --apply does it",
          site.id};
}

}  // namespace

std::vector<PendingPlace> pending_places(const PackageReport& package) {
  std::vector<PendingPlace> places;
  if (package.changes.empty()) return places;
  for (const Site& site : package.report.sites)
    if (site.pending && !site.suppressed) places.push_back(of_site(site));
  if (places.empty())
    places.push_back({codes::TZC5001,
                      {package.report.package_dir + "/" + package.changes.front().path, 1, 1},
                      "the port of this package would change this file: tzc-rewrite --apply does it",
                      ""});
  return places;
}

}  // namespace tzc::rewriter
