// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <set>

#include "edits/files.h"
#include "model/codes.h"
#include "report/output.h"

namespace tzc::rewriter {

DiffStat PackageReport::stat() const {
  DiffStat all;
  for (const FileChange& change : changes)
    all += unified_diff(change.path, change.before, change.after, false).stat;
  return all;
}

bool is_refusal(const Site& site) {
  static const std::set<std::string> asked_for = {codes::TZC1015, codes::TZC1016, codes::TZC2007};
  return site.level == Level::plain && !site.suppressed && !asked_for.count(site.code);
}

std::vector<FlowStep> shown_flow_path(const Site& site) {
  if (site.flow_path.size() != 1 || site.flow_path[0].what != site.reason) return site.flow_path;
  const Location& where = site.flow_path[0].where;
  if (where.file == site.where.file && where.line == site.where.line) return {};
  return {{where, "here"}};
}

std::string relative_file(const Report& report, const std::string& file) {
  return is_below(file, report.package_dir) ? file.substr(report.package_dir.size() + 1) : file;
}

const char* name_of(SiteKind kind) {
  switch (kind) {
    case SiteKind::advertise:
      return "advertise";
    case SiteKind::publish:
      return "publish";
    case SiteKind::subscribe:
      return "subscribe";
  }
  return "";
}

const char* name_of(Level level) {
  switch (level) {
    case Level::zero_copy:
      return "zero_copy";
    case Level::one_copy:
      return "one_copy";
    case Level::plain:
      return "plain";
    case Level::not_needed:
      return "not_needed";
    case Level::shared:
      return "shared";
    case Level::copied:
      return "copied";
  }
  return "";
}

std::vector<Level> levels_of(SiteKind kind) {
  if (kind == SiteKind::subscribe) return {Level::shared, Level::copied, Level::plain, Level::not_needed};
  return {Level::zero_copy, Level::one_copy, Level::plain, Level::not_needed};
}

unsigned count(const Report& report, SiteKind kind, Level level) {
  return static_cast<unsigned>(std::count_if(report.sites.begin(), report.sites.end(), [&](const Site& site) {
    return site.kind == kind && site.level == level;
  }));
}

std::string in_one_line(const Report& report) {
  std::string line;
  for (const SiteKind kind : {SiteKind::publish, SiteKind::subscribe}) {
    std::string counts;
    for (const Level level : levels_of(kind))
      if (const unsigned sites = count(report, kind, level); sites > 0)
        counts += (counts.empty() ? "" : ", ") + std::to_string(sites) + " " + name_of(level);
    if (!counts.empty()) line += (line.empty() ? "" : "; ") + std::string(name_of(kind)) + ": " + counts;
  }
  return line.empty() ? "no sites" : line;
}

}  // namespace tzc::rewriter
