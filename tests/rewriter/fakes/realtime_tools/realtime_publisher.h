// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
namespace realtime_tools {
template <class M>
class RealtimePublisher {
 public:
  M msg_;
  RealtimePublisher() = default;
  RealtimePublisher(const ros::NodeHandle&, const std::string&, int, bool = false) {}
  void init(const ros::NodeHandle&, const std::string&, int, bool = false) {}
  bool trylock() { return true; }
  void unlockAndPublish() {}
};
}  // namespace realtime_tools
