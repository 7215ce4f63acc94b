// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace geometry_msgs {
template <class A>
struct Point_ {
  double x = 0, y = 0, z = 0;
  FAKE_MEMBERS(Point_)
};
}  // namespace geometry_msgs
FAKE_MESSAGE(geometry_msgs, Point)
