// SPDX-License-Identifier: BSD-3-Clause
// usage: recorder TOPIC...
// Writes down every message of the topics, as bytes on the wire.
#include <ros/ros.h>
#include <topic_tools/shape_shifter.h>

#include <vector>

#include "log.h"

namespace {

void record(fuzz::Log& log, const std::string& topic, const topic_tools::ShapeShifter& message) {
  std::vector<std::uint8_t> bytes(message.size());
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  message.write(stream);
  log.write(topic, bytes.data(), bytes.size(), message.getDataType().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "recorder");
  ros::NodeHandle nh;
  fuzz::Log log("recorder.log");
  std::vector<ros::Subscriber> subscribers;
  for (int i = 1; i < argc; ++i) {
    const std::string topic = argv[i];
    subscribers.push_back(nh.subscribe<topic_tools::ShapeShifter>(
        topic, 200,
        [&log, topic](const topic_tools::ShapeShifter::ConstPtr& message) { record(log, topic, *message); }));
  }
  ros::spin();
  return 0;
}
