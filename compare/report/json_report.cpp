// SPDX-License-Identifier: BSD-3-Clause
#include "report/reports.h"

namespace tzc::compare {
namespace {

using nlohmann::json;

json unpaired(const Unpaired& messages) {
  return {{"before", messages.before.size()},
          {"between", messages.between.size()},
          {"after", messages.after.size()}};
}

json finding(const Finding& found) {
  json result{{"cause", name(found.cause)},
              {"count", found.count},
              {"total", found.total},
              {"own_share", found.own_share},
              {"different", found.is_different},
              {"detail", found.detail}};
  if (found.cause == Cause::content) result["field"] = found.field;
  return result;
}

json field(const std::string& path, const FieldCount& count) {
  const FieldDifference& first = count.example;
  return {{"field", path},
          {"messages", count.messages},
          {"first",
           {{"original_message", count.example_pair.first},
            {"port_message", count.example_pair.second},
            {"where", first.where},
            {"original_offset", first.first_offset},
            {"port_offset", first.second_offset},
            {"original", first.first_value},
            {"port", first.second_value}}}};
}

json stream(const StreamVerdict& verdict) {
  const StreamComparison& compared = verdict.comparison;
  json fields = json::array(), findings = json::array();
  for (const auto& [path, count] : compared.fields) fields.push_back(field(path, count));
  for (const Finding& found : verdict.findings) findings.push_back(finding(found));
  return {{"topic", compared.topic},
          {"node", compared.publisher},
          {"type", compared.datatype},
          {"outcome", name(verdict.outcome)},
          {"original_messages", compared.first.messages},
          {"port_messages", compared.second.messages},
          {"paired_by", name(compared.pairing.by)},
          {"pairs", compared.pairing.pairs.size()},
          {"equal", compared.equal},
          {"missing", unpaired(compared.pairing.first_only)},
          {"extra", unpaired(compared.pairing.second_only)},
          {"duplicates", compared.pairing.duplicates},
          {"reordered", compared.pairing.reordered},
          {"fields", fields},
          {"findings", findings}};
}

json resources(const Resources& used) {
  json copies = json::array(), latencies = json::array();
  for (const auto& [topic, entry] : used.copies) {
    json topic_copies{{"topic", topic},
                      {"connections", entry.connections},
                      {"shared_connections", entry.shared},
                      {"deliveries", entry.messages},
                      {"socket_bytes", entry.socket_bytes}};
    if (entry.copied_bytes) topic_copies["copied_into_shared_memory_bytes"] = *entry.copied_bytes;
    copies.push_back(topic_copies);
  }
  for (const auto& [key, latency] : used.latency)
    latencies.push_back({{"topic", key.first},
                         {"node", key.second},
                         {"median_us", latency.median_us},
                         {"p99_us", latency.p99_us},
                         {"messages", latency.messages}});
  return {{"seconds", used.seconds},
          {"cpu_seconds", used.cpu_seconds},
          {"copies", copies},
          {"latency", latencies}};
}

}  // namespace

json json_report(const Result& result) {
  json streams = json::array();
  for (const StreamVerdict& verdict : result.verdicts) streams.push_back(stream(verdict));
  return {{"version", 1},
          {"original", result.original},
          {"port", result.port},
          {"original_runs", result.original_runs},
          {"different", result.is_different()},
          {"judges_first_messages", result.judges_before},
          {"judges_last_messages", result.judges_after},
          {"original_failures", result.own_failures},
          {"port_failures", result.port_failures},
          {"late_topics", result.omissions.late_topics},
          {"topics_left_out", result.omissions.topics},
          {"unknown_fields", result.omissions.unknown_fields},
          {"streams", streams},
          {"original_resources", resources(result.original_resources)},
          {"port_resources", resources(result.port_resources)}};
}

}  // namespace tzc::compare
