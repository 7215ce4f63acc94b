// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <geometry_msgs/Point.h>
#include <sensor_msgs/ChannelFloat32.h>
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct PointCloud_ {
  std_msgs::Header header;
  std::vector<geometry_msgs::Point> points;
  typedef std::vector<ChannelFloat32> _channels_type;
  _channels_type channels;
  FAKE_MEMBERS(PointCloud_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, PointCloud)
