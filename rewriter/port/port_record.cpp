// SPDX-License-Identifier: BSD-3-Clause
#include "port/port_record.h"

#include <nlohmann/json.hpp>

// As CBOR: texts of sources need not be UTF-8, and come back byte by byte.

namespace tzc::rewriter {
namespace {

using nlohmann::json;

json to(const Location& where) {
  return {where.file, where.line, where.column};
}
Location location_from(const json& value) {
  return {value.at(0), value.at(1), value.at(2)};
}

json to(const Site& site) {
  json path = json::array();
  for (const FlowStep& step : site.flow_path) path.push_back({to(step.where), step.what});
  return {{"id", site.id},
          {"kind", static_cast<int>(site.kind)},
          {"where", to(site.where)},
          {"type", site.message_type},
          {"topic", site.topic ? json(*site.topic) : json()},
          {"level", static_cast<int>(site.level)},
          {"code", site.code},
          {"reason", site.reason},
          {"path", path},
          {"rule", site.rule},
          {"suppressed", site.suppressed},
          {"why", site.suppression_reason},
          {"memory", site.memory_note},
          {"pending", site.pending}};
}

Site site_from(const json& value) {
  Site site;
  site.id = value.at("id");
  site.kind = static_cast<SiteKind>(value.at("kind").get<int>());
  site.where = location_from(value.at("where"));
  site.message_type = value.at("type");
  if (!value.at("topic").is_null()) site.topic = value.at("topic").get<std::string>();
  site.level = static_cast<Level>(value.at("level").get<int>());
  site.code = value.at("code");
  site.reason = value.at("reason");
  for (const json& step : value.at("path")) site.flow_path.push_back({location_from(step.at(0)), step.at(1)});
  site.rule = value.at("rule");
  site.suppressed = value.at("suppressed");
  site.suppression_reason = value.at("why");
  site.memory_note = value.at("memory");
  site.pending = value.at("pending");
  return site;
}

json to(const std::vector<Note>& notes) {
  json all = json::array();
  for (const Note& note : notes) all.push_back({note.code, note.where ? to(*note.where) : json(), note.text});
  return all;
}

std::vector<Note> notes_from(const json& value) {
  std::vector<Note> notes;
  for (const json& note : value) {
    notes.push_back({note.at(0), std::nullopt, note.at(2)});
    if (!note.at(1).is_null()) notes.back().where = location_from(note.at(1));
  }
  return notes;
}

json to(const PackageReport& package) {
  json sites = json::array(), changes = json::array(), pending = json::array();
  for (const Site& site : package.report.sites) sites.push_back(to(site));
  for (const FileChange& change : package.changes)
    changes.push_back({change.path, change.before, change.after});
  for (const PendingPlace& place : package.pending)
    pending.push_back({place.code, to(place.where), place.text, place.site_id});
  return {{"package", package.report.package},
          {"folder", package.report.package_dir},
          {"sites", sites},
          {"notes", to(package.report.notes)},
          {"changes", changes},
          {"pending", pending},
          {"root", package.source_root}};
}

PackageReport report_from(const json& value) {
  PackageReport package;
  package.report.package = value.at("package");
  package.report.package_dir = value.at("folder");
  for (const json& site : value.at("sites")) package.report.sites.push_back(site_from(site));
  package.report.notes = notes_from(value.at("notes"));
  for (const json& change : value.at("changes"))
    package.changes.push_back({change.at(0), change.at(1), change.at(2)});
  for (const json& place : value.at("pending"))
    package.pending.push_back({place.at(0), location_from(place.at(1)), place.at(2), place.at(3)});
  package.source_root = value.at("root");
  return package;
}

json to(const PackagePort& port) {
  return {{"folder", port.package_dir}, {"contents", port.contents}, {"result", to(port.result)},
          {"build", port.build_dir},    {"units", port.units},       {"hints", to(port.hints)},
          {"refused", port.refused}};
}

PackagePort port_from(const json& value) {
  PackagePort port;
  port.package_dir = value.at("folder");
  port.contents = value.at("contents").get<FileContents>();
  port.result = report_from(value.at("result"));
  port.build_dir = value.at("build");
  port.units = value.at("units").get<std::set<std::string>>();
  port.hints = notes_from(value.at("hints"));
  port.refused = value.at("refused");
  return port;
}

}  // namespace

std::string encoded(const PortRecord& record) {
  json places = json::array(), ports = json::array();
  for (const auto& [place, state] : record.places)
    places.push_back({place.first, static_cast<int>(place.second), state});
  for (const PackagePort& port : record.ports) ports.push_back(to(port));
  std::string bytes;
  json::to_cbor(json{{"places", places}, {"ports", ports}}, bytes);
  return bytes;
}

std::optional<PortRecord> decoded(const std::string& bytes) {
  try {
    const json document = json::from_cbor(bytes);
    PortRecord record;
    for (const json& place : document.at("places"))
      record.places[{place.at(0), static_cast<Access>(place.at(1).get<int>())}] = place.at(2);
    for (const json& port : document.at("ports")) record.ports.push_back(port_from(port));
    return record;
  } catch (const json::exception&) {
    return {};
  }
}

}  // namespace tzc::rewriter
