// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nav_msgs/OccupancyGrid.h>
namespace nav_msgs {
template <class A>
struct GetMapRequest_ {
  FAKE_MEMBERS(GetMapRequest_)
};
template <class A>
struct GetMapResponse_ {
  nav_msgs::OccupancyGrid map;
  FAKE_MEMBERS(GetMapResponse_)
};
typedef GetMapRequest_<std::allocator<void>> GetMapRequest;
typedef GetMapResponse_<std::allocator<void>> GetMapResponse;
struct GetMap {
  typedef GetMapRequest Request;
  typedef GetMapResponse Response;
};
}  // namespace nav_msgs
