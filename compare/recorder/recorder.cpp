// SPDX-License-Identifier: BSD-3-Clause
#include "recorder/recorder.h"

#include <tzc/subscribe.h>

#include <algorithm>

#include "preload/codec_table.h"
#include "wire/masks.h"

namespace tzc::compare {
namespace {

using nlohmann::json;

// As many as memory holds: the recorder itself must lose nothing.
constexpr std::uint32_t queue_size = 1'000'000;
constexpr double traffic_period_s = 1;

/// The stamp of a message that begins with a header; 0 for others.
std::int64_t stamp_of(const topic_tools::ShapeShifter& message) {
  const auto root = parse_definition(message.getDataType(), message.getMessageDefinition());
  if (!root) return 0;
  Bytes bytes(message.size());
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.write(stream);
  const auto header = header_stamp(*root, bytes);
  return header ? header->nanoseconds : 0;
}

}  // namespace

Recorder::Recorder(RecorderOptions options)
    : options_(std::move(options)), filter_(options_.topics, options_.excluded), writer_(options_.bag) {}

bool Recorder::is_input(const std::string& topic) const {
  const auto found = graph_.publishers.find(topic);
  return found != graph_.publishers.end() && found->second.count(options_.player) != 0;
}

void Recorder::update() {
  if (!read_graph(graph_)) return;
  for (const auto& [topic, publishers] : graph_.publishers) {
    const bool is_recorded = filter_.accepts(topic);
    if (!is_recorded && (!is_input(topic) || TopicFilter::is_infrastructure(topic))) continue;
    if (is_recorded) {
      auto& [type, nodes] = seen_[topic];
      type = graph_.types[topic];
      nodes.insert(publishers.begin(), publishers.end());
      if (subscriptions_.count(topic) == 0 && log_.input_messages() != 0) late_.insert(topic);
    }
    if (subscriptions_.count(topic) == 0) subscribe(topic, is_recorded);
  }
  if (ros::WallTime::now() < next_traffic_) return;
  traffic_.update(graph_);
  next_traffic_ = ros::WallTime::now() + ros::WallDuration(traffic_period_s);
}

void Recorder::subscribe(const std::string& topic, bool is_recorded) {
  const auto codec = codec_table().find(graph_.types[topic]);
  if (options_.uses_shared_memory && codec != codec_table().end()) detail::attach_topic(topic, codec->second);
  boost::function<void(const Event&)> callback = [this, topic, is_recorded](const Event& event) {
    on_message(topic, event, is_recorded);
  };
  ros::TransportHints hints;
  subscriptions_[topic] =
      node_.subscribe<const Event&>(topic, queue_size, callback, ros::VoidConstPtr(), hints.tcpNoDelay());
}

void Recorder::on_message(const std::string& topic, const Event& event, bool is_recorded) {
  const ros::WallTime received = ros::WallTime::now();
  const topic_tools::ShapeShifter::ConstPtr& message = event.getConstMessage();
  if (event.getPublisherName() == options_.player)
    return log_.add_input(stamp_of(*message), static_cast<std::int64_t>(received.toNSec()));
  if (!is_recorded) return;
  writer_.add({topic, ros::Time(received.sec, received.nsec), message, event.getConnectionHeaderPtr()});
  log_.count_message();
}

bool Recorder::is_ready() const {
  return std::all_of(subscriptions_.begin(), subscriptions_.end(), [&](const auto& entry) {
    const auto publishers = graph_.publishers.find(entry.first);
    return publishers == graph_.publishers.end() ||
           entry.second.getNumPublishers() >= publishers->second.size();
  });
}

json Recorder::status() const {
  const std::size_t own_topics = static_cast<std::size_t>(
      std::count_if(seen_.begin(), seen_.end(), [&](const auto& entry) { return !is_input(entry.first); }));
  return {{"graph", graph_.fingerprint()}, {"nodes", graph_.nodes()},     {"topics", own_topics},
          {"ready", is_ready()},           {"messages", log_.messages()}, {"inputs", log_.input_messages()},
          {"error", writer_.error()}};
}

json Recorder::summary() {
  traffic_.update(graph_);
  json topics = json::array(), left_out = json::array(), inputs = json::array();
  for (const auto& [topic, entry] : seen_) {
    std::set<std::string> publishers = entry.second;
    publishers.erase(options_.player);
    if (!publishers.empty())
      topics.push_back({{"topic", topic}, {"type", entry.first}, {"publishers", publishers}});
  }
  for (const auto& [topic, publishers] : graph_.publishers) {
    const bool is_only_input = publishers == std::set<std::string>{options_.player};
    if (!filter_.accepts(topic) && !TopicFilter::is_infrastructure(topic) && !is_only_input)
      left_out.push_back(topic);
  }
  for (const auto& [stamp, received] : log_.inputs()) inputs.push_back({stamp, received});
  return {{"now", static_cast<std::int64_t>(ros::WallTime::now().toNSec())},
          {"traffic", traffic_.to_json()},
          {"topics", topics},
          {"late", late_},
          {"left_out", left_out},
          {"inputs", inputs}};
}

}  // namespace tzc::compare
