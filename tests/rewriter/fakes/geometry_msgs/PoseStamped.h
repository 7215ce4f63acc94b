// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <geometry_msgs/Point.h>
#include <std_msgs/Header.h>
namespace geometry_msgs {
template <class A>
struct PoseStamped_ {
  std_msgs::Header header;
  geometry_msgs::Point position;
  FAKE_MEMBERS(PoseStamped_)
};
}  // namespace geometry_msgs
FAKE_MESSAGE(geometry_msgs, PoseStamped)
