// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>
namespace visualization_msgs {
template <class A>
struct MarkerArray_ {
  std::vector<visualization_msgs::Marker> markers;
  FAKE_MEMBERS(MarkerArray_)
};
}  // namespace visualization_msgs
FAKE_MESSAGE(visualization_msgs, MarkerArray)
