// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "recorder/bag_writer.h"
#include "recorder/graph.h"
#include "recorder/message_log.h"
#include "recorder/topic_filter.h"
#include "recorder/traffic.h"

namespace tzc::compare {

struct RecorderOptions {
  std::string bag;     ///< where the messages go
  std::string player;  ///< the node whose messages are the input: of those only the times are kept
  std::vector<std::string> topics, excluded;  ///< regular expressions; no topics: all
  bool uses_shared_memory =
      true;  ///< messages come as TZC's subscribers get them, for types that were installed with TZC
};

/// Records the messages of the nodes of a graph, of every type.
///
/// Data flow: master -> Graph -> subscriptions -> BagWriter. The callbacks run on the spinner's threads, all
/// else on the caller's.
class Recorder {
 public:
  explicit Recorder(RecorderOptions options);

  /// Subscribes to new topics, to those of the input whatever the options select, and from time to time reads the
  /// nodes' counters.
  void update();
  /// {"graph", "nodes", "topics", "ready", "messages", "inputs", "error"}
  nlohmann::json status() const;
  /// {"now", "traffic", "topics": [{"topic", "type", "publishers"}], "inputs": [[stamp, received], ...],
  /// "late", "left_out"}
  nlohmann::json summary();

 private:
  using Event = ros::MessageEvent<topic_tools::ShapeShifter const>;

  bool is_input(const std::string& topic) const;
  /// @param is_recorded false: it is looked at for the times of the input alone
  void subscribe(const std::string& topic, bool is_recorded);
  void on_message(const std::string& topic, const Event& event, bool is_recorded);
  /// Every publisher that the master knows is connected to us.
  bool is_ready() const;

  const RecorderOptions options_;
  const TopicFilter filter_;
  ros::NodeHandle node_;
  Graph graph_;
  Traffic traffic_;
  ros::WallTime next_traffic_;
  std::map<std::string, ros::Subscriber> subscriptions_;
  std::set<std::string>
      late_;  ///< topics that were advertised after the input began: their first messages are not recorded
  std::map<std::string, std::pair<std::string, std::set<std::string>>> seen_;  ///< topic -> type, publishers

  MessageLog log_;
  BagWriter writer_;
};

}  // namespace tzc::compare
