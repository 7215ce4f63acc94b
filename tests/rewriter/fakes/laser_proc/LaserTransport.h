// SPDX-License-Identifier: BSD-3-Clause
// The declarations of laser_proc that cases use.
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/MultiEchoLaserScan.h>

#include <string>
#include <vector>

namespace laser_proc {
class LaserPublisher {
 public:
  uint32_t getNumSubscribers() const;
  std::vector<std::string> getTopics() const;
  void publish(const sensor_msgs::MultiEchoLaserScan& message) const;
  void publish(const sensor_msgs::MultiEchoLaserScanConstPtr& message) const;
  void shutdown();
  operator void*() const;
};

class LaserTransport {
 public:
  static LaserPublisher advertiseLaser(ros::NodeHandle& nh, uint32_t queue_size, bool latch = false,
                                       bool publish_echoes = true);
};
}  // namespace laser_proc
