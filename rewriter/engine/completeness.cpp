// SPDX-License-Identifier: BSD-3-Clause
#include "engine/completeness.h"

#include <map>
#include <tuple>

#include "model/folder_set.h"
#include "report/output.h"

namespace tzc::rewriter {
namespace {

auto order_of(const SiteKind kind, const Location& where) {
  return std::make_tuple(where.file, where.line, where.column, static_cast<int>(kind));
}

using Spot = decltype(order_of(SiteKind::publish, Location()));

Error broken(const Report& report, SiteKind kind, const Location& where, const std::string& what) {
  return {std::string("the report is wrong: this ") + name_of(kind) + " call " + what,
          relative_file(report, where.file) + ":" + std::to_string(where.line) + ":" +
              std::to_string(where.column),
          "this is a defect of tzc-rewrite, please report it; nothing was written"};
}

}  // namespace

Expected<void> check_complete(const Report& report, const std::set<ApiCall>& calls) {
  std::map<Spot, std::multiset<std::string>> reported;
  for (const Site& site : report.sites) reported[order_of(site.kind, site.where)].insert(site.message_type);
  std::set<Spot> spots;
  for (const ApiCall& call : calls) {
    if (!is_below(call.where.file, report.package_dir)) continue;
    const Spot spot = order_of(call.kind, call.where);
    spots.insert(spot);
    const auto found = reported.find(spot);
    if (found == reported.end()) return broken(report, call.kind, call.where, "is not in it");
    if (!call.type.empty() && found->second.count(call.type) != 1)
      return broken(
          report, call.kind, call.where,
          "is in it " + std::to_string(found->second.count(call.type)) + " times with " + call.type);
  }
  for (const Site& site : report.sites)
    if (spots.count(order_of(site.kind, site.where)) == 0)
      return broken(report, site.kind, site.where, "is in it, but not in the package (" + site.id + ")");
  return {};
}

}  // namespace tzc::rewriter
