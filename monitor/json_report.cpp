// SPDX-License-Identifier: BSD-3-Clause
#include "json_report.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "latency.h"
#include "problems.h"
#include "words.h"

namespace tzc::monitor {
namespace {

using nlohmann::json;

json connection_json(const Connection& connection) {
  return {{"subscriber", connection.subscriber},
          {"transport", name(connection.transport)},
          {"reason", connection.reason},
          {"messages", connection.messages},
          {"per_second", connection.messages_per_s ? json(*connection.messages_per_s) : json()},
          {"bytes", connection.bytes},
          {"in_flight", connection.in_flight},
          {"held", connection.held},
          {"revoked", connection.revoked},
          {"revoked_by_cause",
           {{"queue_full", connection.revoked_for_queue},
            {"memory_needed", connection.revoked_for_memory},
            {"subscriber_left", connection.revoked_at_end}}},
          {"oldest_held_s", connection.oldest_held_s},
          {"shared_bytes", connection.shared_bytes},
          {"shared_bytes_per_second",
           connection.shared_bytes_per_s ? json(*connection.shared_bytes_per_s) : json()},
          {"pid", connection.pid == 0 ? json() : json(connection.pid)},
          {"stopped", connection.is_stopped}};
}

json rates_json(const Rates& rates) {
  return {{"messages", rates.messages},
          {"shared", rates.shared},
          {"serialized", rates.serialized},
          {"copied_bytes", rates.copied_bytes},
          {"exhausted", rates.exhausted}};
}

/// null: the last bucket has no end.
json end_json(std::size_t bucket) {
  const double end = bucket_end_us(bucket);
  return std::isinf(end) ? json() : json(end);
}

json latency_json(const Latencies& latencies) {
  json buckets = json::array();
  for (std::size_t i = 0; i < latencies.size(); ++i)
    if (latencies[i] > 0) buckets.push_back({{"below_us", end_json(i)}, {"messages", latencies[i]}});
  return buckets;
}

json subscription_json(const Subscription& one) {
  return {{"topic", one.topic},
          {"publisher", one.publisher},
          {"transport", name(one.transport)},
          {"messages", one.messages},
          {"per_second", one.messages_per_s ? json(*one.messages_per_s) : json()},
          {"lost", one.lost},
          {"bytes", one.bytes},
          {"shared_bytes", one.shared_bytes},
          {"held_messages", one.held_messages},
          {"held_bytes", one.held_bytes},
          {"latency", latency_json(one.latencies)},
          {"latency_since_last_look", latency_json(one.recent)},
          {"pid", one.pid == 0 ? json() : json(one.pid)},
          {"stopped", one.is_stopped}};
}

json topic_json(const Topic& topic, const std::optional<Rates>& rates) {
  json connections = json::array();
  for (const Connection& connection : topic.connections) connections.push_back(connection_json(connection));
  return {{"topic", topic.name},
          {"type", topic.type},
          {"messages", topic.counters.messages},
          {"shared", topic.counters.shared},
          {"serialized", topic.counters.serialized},
          {"copied_bytes", topic.counters.copied_bytes},
          {"control_bytes", topic.counters.control_bytes},
          {"exhausted", topic.counters.exhausted},
          {"dropped", topic.counters.dropped},
          {"revoked", topic.counters.revoked},
          {"memory",
           {{"segments", topic.memory.segments},
            {"size", topic.memory.size},
            {"committed", topic.memory.committed},
            {"used", topic.memory.used},
            {"blocks", topic.memory.blocks}}},
          {"per_second", rates ? rates_json(*rates) : json()},
          {"connections", connections}};
}

json node_json(const Node& node) {
  json topics = json::array();
  for (std::size_t i = 0; i < node.topics.size(); ++i)
    topics.push_back(topic_json(node.topics[i], i < node.rates.size() ? node.rates[i] : std::nullopt));
  json subscriptions = json::array();
  for (const Subscription& one : node.subscriptions) subscriptions.push_back(subscription_json(one));
  return {
      {"node", node.name},         {"pid", node.pid},  {"state", name(node.state)},     {"age_s", node.age_s},
      {"left_out", node.left_out}, {"topics", topics}, {"subscriptions", subscriptions}};
}

}  // namespace

std::string json_report(const std::vector<Node>& nodes) {
  json report{{"version", 1}, {"nodes", json::array()}, {"problems", json::array()}};
  for (const Problem& problem : problems(nodes))
    report["problems"].push_back(
        {{"kind", name(problem.kind)}, {"node", problem.node}, {"text", problem.text}});
  for (const Node& node : nodes) report["nodes"].push_back(node_json(node));
  return report.dump(2) + "\n";
}

}  // namespace tzc::monitor
