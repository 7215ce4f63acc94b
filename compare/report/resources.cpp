// SPDX-License-Identifier: BSD-3-Clause
#include "report/result.h"
#include "run/load_bag.h"

namespace tzc::compare {
namespace {

void add_traffic(const nlohmann::json& summary, std::map<std::string, Copies>& copies) {
  for (const auto& connection : summary["traffic"]) {
    Copies& topic = copies[connection["topic"]];
    topic.messages += connection["messages"].get<std::uint64_t>();
    topic.socket_bytes += connection["bytes"].get<std::uint64_t>();
    ++topic.connections;
    if (connection["transport"] == "TZC") ++topic.shared;
  }
}

void add_statistics(const std::vector<nlohmann::json>& statistics, std::map<std::string, Copies>& copies) {
  for (const auto& entry : statistics) {
    Copies& topic = copies[entry["topic"]];
    topic.published = topic.published.value_or(0) + entry.value("messages", std::uint64_t{0});
    topic.copied_bytes = topic.copied_bytes.value_or(0) + entry.value("copied_bytes", std::uint64_t{0});
  }
}

}  // namespace

Resources resources_of(const Run& run, const Recording& recording) {
  Resources resources;
  resources.cpu_seconds = run.cpu_seconds;
  resources.seconds = run.seconds;
  add_traffic(run.summary, resources.copies);
  add_statistics(run.statistics, resources.copies);
  resources.copies.erase("/rosout");
  const InputTimes inputs = load_inputs(run.summary);
  for (const Stream& stream : recording) {
    if (const auto latency = latency_of(stream, inputs)) resources.latency[stream.key()] = *latency;
  }
  return resources;
}

}  // namespace tzc::compare
