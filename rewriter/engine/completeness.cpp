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
  std::map<Spot, std::multiset<std::string>> seen;  // one macro may make several calls of a type
  for (const ApiCall& call : calls)
    if (is_below(call.where.file, report.package_dir))
      seen[order_of(call.kind, call.where)].insert(call.type);
  for (const ApiCall& call : calls) {
    const Spot spot = order_of(call.kind, call.where);
    if (seen.count(spot) == 0) continue;
    const auto found = reported.find(spot);
    if (found == reported.end()) return broken(report, call.kind, call.where, "is not in it");
    const std::size_t wanted = seen[spot].count(call.type), there = found->second.count(call.type);
    if (!call.type.empty() && there != wanted)
      return broken(report, call.kind, call.where,
                    "is in it " + std::to_string(there) + " times with " + call.type + ", and not " +
                        std::to_string(wanted));
  }
  for (const Site& site : report.sites)
    if (seen.count(order_of(site.kind, site.where)) == 0)
      return broken(report, site.kind, site.where, "is in it, but not in the package (" + site.id + ")");
  return {};
}

}  // namespace tzc::rewriter
