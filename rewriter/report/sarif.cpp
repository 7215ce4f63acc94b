// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "report/codes.h"
#include "report/output.h"

namespace tzc::rewriter {
namespace {

using json = nlohmann::ordered_json;

/// Percent-encoded as RFC 3986 wants paths.
std::string as_uri(const std::string& path) {
  static const std::string plain = "-._~/";
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    const bool keep = (byte < 128 && std::isalnum(byte)) || plain.find(c) != std::string::npos;
    uri += keep ? std::string(1, c)
                : std::string("%") + "0123456789ABCDEF"[byte >> 4] + "0123456789ABCDEF"[byte & 15];
  }
  return uri;
}

/// Each package has a base of its own: PACKAGE_camera_pair.
std::string base_id(const Report& report) {
  return "PACKAGE_" + report.package;
}

json location(const Report& report, const Location& where) {
  const std::string file = relative_file(report, where.file);
  json artifact = {{"uri", file == where.file ? "file://" + as_uri(file) : as_uri(file)}};
  if (file != where.file) artifact["uriBaseId"] = base_id(report);
  json physical = {{"artifactLocation", artifact}};
  if (where.line > 0)
    physical["region"] = {{"startLine", where.line}, {"startColumn", std::max(1u, where.column)}};
  return {{"physicalLocation", physical}};
}

json flow(const Report& report, const Site& site) {
  json locations = json::array();
  for (const FlowStep& step : site.chain) {
    json at = location(report, step.where);
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

json site_result(const Report& report, const Site& site) {
  const std::string text = std::string(name_of(site.kind)) + " of " + site.message_type + " is " +
                           name_of(site.level) + (site.reason.empty() ? "" : ": " + site.reason);
  json object = result(site.code, site.level == Level::plain ? "warning" : "note", text);
  object["locations"] = json::array({location(report, site.where)});
  if (!site.chain.empty()) object["codeFlows"] = flow(report, site);
  if (site.suppressed)
    object["suppressions"] =
        json::array({{{"kind", "inSource"}, {"justification", site.suppression_reason}}});
  object["partialFingerprints"] = {{"tzcSite/v1", site.id}};
  object["properties"] = {{"portLevel", name_of(site.level)},
                          {"topic", site.topic ? json(*site.topic) : json(nullptr)}};
  return object;
}

json note_result(const Report& report, const Note& note) {
  json object = result(note.code, "note", note.text);
  if (note.where) object["locations"] = json::array({location(report, *note.where)});
  return object;
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

json results(const RunReport& run) {
  json all = json::array();
  for (const PackageReport& package : run) {
    for (const Site& site : package.report.sites)
      if (!site.code.empty()) all.push_back(site_result(package.report, site));
    for (const Note& note : package.report.notes) all.push_back(note_result(package.report, note));
  }
  return all;
}

}  // namespace

std::string to_sarif(const RunReport& run, const std::string& tool_version) {
  json bases = json::object();
  for (const PackageReport& package : run)
    bases[base_id(package.report)] = {{"uri", "file://" + as_uri(package.report.package_dir) + "/"}};
  const json driver = {{"name", "tzc-rewrite"}, {"semanticVersion", tool_version}, {"rules", rules()}};
  const json document = {{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                         {"version", "2.1.0"},
                         {"runs", json::array({{{"tool", {{"driver", driver}}},
                                                {"columnKind", "utf16CodeUnits"},
                                                {"originalUriBaseIds", bases},
                                                {"results", results(run)}}})}};
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace tzc::rewriter
