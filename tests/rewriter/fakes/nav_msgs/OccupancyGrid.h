// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace nav_msgs {
template <class A>
struct OccupancyGrid_ {
  std_msgs::Header header;
  uint32_t height = 0, width = 0;
  typedef std::vector<int8_t> _data_type;
  _data_type data;
  FAKE_MEMBERS(OccupancyGrid_)
};
}  // namespace nav_msgs
FAKE_MESSAGE(nav_msgs, OccupancyGrid)
