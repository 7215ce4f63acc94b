// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct Imu_ {
  std_msgs::Header header;
  double x = 0;
  FAKE_MEMBERS(Imu_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, Imu)
