// SPDX-License-Identifier: BSD-3-Clause
#include <nlohmann/json.hpp>

#include "report/estimate.h"
#include "report/output.h"

namespace tzc::rewriter {
namespace {

using json = nlohmann::ordered_json;

json place(const Report& report, const Location& where) {
  return {{"file", relative_file(report, where.file)}, {"line", where.line}, {"column", where.column}};
}

json site_json(const Report& report, const Site& site) {
  json object = {{"id", site.id}, {"kind", name_of(site.kind)}};
  object.update(place(report, site.where));
  object["message_type"] = site.message_type;
  object["topic"] = site.topic ? json(*site.topic) : json(nullptr);
  object["level"] = name_of(site.level);
  object["code"] = site.code;
  object["reason"] = site.reason;
  object["rule"] = site.rule;
  object["memory"] = site.memory_note;
  object["suppressed"] = site.suppressed;
  object["chain"] = json::array();
  for (const FlowStep& step : site.flow_path) {
    json entry = place(report, step.where);
    entry["what"] = step.what;
    object["chain"].push_back(entry);
  }
  return object;
}

json note_json(const Report& report, const Note& note) {
  json object = {{"code", note.code}, {"text", note.text}};
  object.update(note.where ? place(report, *note.where)
                           : json{{"file", nullptr}, {"line", nullptr}, {"column", nullptr}});
  return object;
}

json counts(const Report& report, SiteKind kind) {
  json object = {{"total", 0}};
  unsigned total = 0;
  for (const Level level : levels_of(kind)) {
    object[name_of(level)] = count(report, kind, level);
    total += count(report, kind, level);
  }
  object["total"] = total;
  return object;
}

json estimate_json(const PackageReport& package) {
  const EstimateSum sum = sum_of(estimates(package));
  return {{"copies_now", sum.before},
          {"copies_after", sum.after},
          {"bytes_now", sum.bytes_before},
          {"bytes_after", sum.bytes_after},
          {"sites_of_unknown_size", sum.sites - sum.measured - sum.usual}};
}

json package_json(const PackageReport& package) {
  const Report& report = package.report;
  json sites = json::array(), notes = json::array();
  for (const Site& site : report.sites) sites.push_back(site_json(report, site));
  for (const Note& note : report.notes) notes.push_back(note_json(report, note));
  const DiffStat stat = package.stat();
  return {{"version", 1},
          {"package", report.package},
          {"sites", sites},
          {"notes", notes},
          {"summary",
           {{"publish", counts(report, SiteKind::publish)},
            {"subscribe", counts(report, SiteKind::subscribe)},
            {"estimate", estimate_json(package)},
            {"files_changed", stat.files},
            {"lines_added", stat.added},
            {"lines_removed", stat.removed}}}};
}

}  // namespace

std::string to_json(const RunReport& run) {
  json document = {{"version", 1}, {"packages", json::array()}};
  for (const PackageReport& package : run) document["packages"].push_back(package_json(package));
  if (run.size() == 1) document = document["packages"][0];
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace tzc::rewriter
