// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <geometry_msgs/PoseStamped.h>
namespace nav_msgs {
template <class A>
struct Path_ {
  std_msgs::Header header;
  typedef std::vector<geometry_msgs::PoseStamped> _poses_type;
  _poses_type poses;
  FAKE_MEMBERS(Path_)
};
}  // namespace nav_msgs
FAKE_MESSAGE(nav_msgs, Path)
