// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <geometry_msgs/Point.h>
#include <std_msgs/Header.h>
namespace visualization_msgs {
template <class A>
struct Marker_ {
  std_msgs::Header header;
  int type = 0;
  std::string text;
  std::vector<geometry_msgs::Point> points;
  FAKE_MEMBERS(Marker_)
};
}  // namespace visualization_msgs
FAKE_MESSAGE(visualization_msgs, Marker)
