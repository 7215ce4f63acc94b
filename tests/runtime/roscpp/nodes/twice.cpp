// SPDX-License-Identifier: BSD-3-Clause
/// Advertises two topics with the same options, and prints whether a callback is in them that it did not set.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cstdio>

int main(int argc, char** argv) {
  ros::init(argc, argv, "twice");
  ros::NodeHandle node;
  ros::AdvertiseOptions options = ros::AdvertiseOptions::create<sensor_msgs::Image>(
      "left", 1, ros::SubscriberStatusCallback(), ros::SubscriberStatusCallback(), ros::VoidConstPtr(),
      nullptr);
  const ros::Publisher left = node.advertise(options);
  const bool is_changed = !options.connect_cb.empty();
  options.topic = "right";
  const ros::Publisher right = node.advertise(options);
  std::printf("{\"event\": \"a callback is in them\", \"happened\": %s}\n", is_changed ? "true" : "false");
  return left.getTopic() != right.getTopic() ? 0 : 1;
}
