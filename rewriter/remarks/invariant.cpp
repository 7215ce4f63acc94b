// SPDX-License-Identifier: BSD-3-Clause
#include "remarks/invariant.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "report/code_pages.h"
#include "report/output.h"

namespace tzc::rewriter {
namespace {

Error broken(const Report& report, const Site& site, const std::string& what) {
  return {"the report is wrong: " + what + " (" + name_of(site.kind) + ", id " + site.id + ")",
          relative_file(report, site.where.file) + ":" + std::to_string(site.where.line),
          "this is a defect of tzc-rewrite, please report it; nothing was written"};
}

bool level_fits(const Site& site) {
  const std::vector<Level> levels = levels_of(site.kind);
  return std::find(levels.begin(), levels.end(), site.level) != levels.end();
}

}  // namespace

Expected<void> check_report(const Report& report) {
  std::set<std::string> ids;
  std::set<std::tuple<SiteKind, std::string, unsigned, unsigned, std::string, std::vector<unsigned>>> places;
  for (const Site& site : report.sites) {
    if (site.id.empty() || !ids.insert(site.id).second) return broken(report, site, "its id is not its own");
    const Location& at = site.where;
    if (!places.insert({site.kind, at.file, at.line, at.column, site.message_type, site.in_macros}).second)
      return broken(report, site, "one site stands in it twice");
    if (!level_fits(site)) return broken(report, site, "its level does not fit its kind");
    if (site.level == Level::plain && site.code.empty())
      return broken(report, site, "it is not ported and no code says why");
    if (!site.code.empty() && !find_code(site.code)) return broken(report, site, "its code does not exist");
  }
  return {};
}

}  // namespace tzc::rewriter
