// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
#include <visualization_msgs/Marker.h>
namespace visualization_msgs {
template <class A>
struct MarkerArray_ {
  typedef std::vector<visualization_msgs::Marker> _markers_type;
  _markers_type markers;
  FAKE_MEMBERS(MarkerArray_)
};
}  // namespace visualization_msgs
FAKE_MESSAGE(visualization_msgs, MarkerArray)
