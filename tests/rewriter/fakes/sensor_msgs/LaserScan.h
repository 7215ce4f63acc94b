// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct LaserScan_ {
  std_msgs::Header header;
  float angle_min = 0, angle_max = 0;
  std::vector<float> ranges;
  std::vector<float> intensities;
  FAKE_MEMBERS(LaserScan_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, LaserScan)
