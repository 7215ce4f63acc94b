// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct ChannelFloat32_ {
  std::string name;
  std::vector<float> values;
  FAKE_MEMBERS(ChannelFloat32_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, ChannelFloat32)
