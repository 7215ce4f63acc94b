// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct LaserEcho_ {
  std::vector<float> echoes;
  FAKE_MEMBERS(LaserEcho_)
};
typedef LaserEcho_<std::allocator<void>> LaserEcho;
template <class A>
struct MultiEchoLaserScan_ {
  std_msgs::Header header;
  float angle_min = 0, angle_max = 0;
  std::vector<LaserEcho> ranges;
  std::vector<LaserEcho> intensities;
  FAKE_MEMBERS(MultiEchoLaserScan_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, MultiEchoLaserScan)
