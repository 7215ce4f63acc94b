// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "edits/files.h"
#include "report/code_pages.h"
#include "report/output.h"
#include "report/sarif_fix.h"
#include "report/sarif_places.h"

namespace tzc::rewriter {
namespace {

using json = nlohmann::ordered_json;

json flow(const PackageReport& package, const Site& site, const SarifPlaces& places) {
  json locations = json::array();
  for (const FlowStep& step : site.flow_path) {
    json at = places.location(package, step.where);
    at["message"] = {{"text", step.what}};
    locations.push_back({{"location", at}});
  }
  return json::array({{{"threadFlows", json::array({{{"locations", locations}}})}}});
}

int rule_index(const std::string& code) {
  const auto& all = all_codes();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const CodeInfo& info) { return info.code == code; });
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

json result(const std::string& code, const char* level, const std::string& text) {
  json object = {{"ruleId", code}};
  if (rule_index(code) >= 0) object["ruleIndex"] = rule_index(code);
  object["level"] = level;
  object["message"] = {{"text", text}};
  return object;
}

json site_result(const PackageReport& package, const Site& site, const SarifPlaces& places) {
  const std::string text = std::string(name_of(site.kind)) + " of " + site.message_type + " is " +
                           name_of(site.level) + (site.reason.empty() ? "" : ": " + site.reason);
  json object = result(site.code, site.level == Level::plain ? "warning" : "note", text);
  object["locations"] = json::array({places.location(package, site.where)});
  if (!site.flow_path.empty()) object["codeFlows"] = flow(package, site, places);
  if (site.suppressed)
    object["suppressions"] =
        json::array({{{"kind", "inSource"}, {"justification", site.suppression_reason}}});
  object["partialFingerprints"] = {{"tzcSite/v1", site.id}};
  object["properties"] = {{"portLevel", name_of(site.level)},
                          {"topic", site.topic ? json(*site.topic) : json(nullptr)}};
  return object;
}

json note_result(const PackageReport& package, const Note& note, const SarifPlaces& places) {
  json object = result(note.code, "note", note.text);
  if (note.where) object["locations"] = json::array({places.location(package, *note.where)});
  return object;
}

json pending_results(const PackageReport& package, const SarifPlaces& places) {
  json all = json::array();
  if (package.pending.empty()) return all;
  const json fixes = sarif_fixes(package, places);
  const bool each =
      fixes.dump(-1, ' ', false, json::error_handler_t::replace).size() * package.pending.size() <=
      largest_fixes;
  for (const PendingPlace& place : package.pending) {
    json object = result(place.code, "warning", place.text);
    object["locations"] = json::array({places.location(package, place.where)});
    if (!place.site_id.empty()) object["partialFingerprints"] = {{"tzcSite/v1", place.site_id}};
    if (each || all.empty()) object["fixes"] = fixes;
    all.push_back(object);
  }
  return all;
}

json rules() {
  json all = json::array();
  for (const CodeInfo& info : all_codes())
    all.push_back(
        {{"id", info.code},
         {"name", info.slug},
         {"shortDescription", {{"text", info.title}}},
         {"help", {{"text", info.page.empty() ? info.title : info.page}, {"markdown", info.page}}}});
  return all;
}

json results(const RunReport& run, const SarifPlaces& places) {
  json all = json::array();
  for (const PackageReport& package : run) {
    for (const Site& site : package.report.sites)
      if (!site.code.empty()) all.push_back(site_result(package, site, places));
    for (const Note& note : package.report.notes) all.push_back(note_result(package, note, places));
    for (const json& pending : pending_results(package, places)) all.push_back(pending);
  }
  return all;
}

/// Tells runs over different packages apart, so that code scanning closes no alert of another one.
std::string automation_id(const RunReport& run) {
  constexpr std::size_t longest = 120;
  std::string names;
  for (const PackageReport& package : run) names += (names.empty() ? "" : "+") + package.report.package;
  if (names.size() > longest) names = names.substr(0, longest) + "-" + std::to_string(content_hash(names));
  return "tzc-rewrite/" + names + "/";
}

}  // namespace

std::string to_sarif(const RunReport& run, const std::string& tool_version) {
  const SarifPlaces places(run);
  const json driver = {{"name", "tzc-rewrite"}, {"semanticVersion", tool_version}, {"rules", rules()}};
  const json document = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                         {"version", "2.1.0"},
                         {"runs", json::array({{{"tool", {{"driver", driver}}},
                                                {"columnKind", "utf16CodeUnits"},
                                                {"automationDetails", {{"id", automation_id(run)}}},
                                                {"originalUriBaseIds", places.bases()},
                                                {"results", results(run, places)}}})}};
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace tzc::rewriter
