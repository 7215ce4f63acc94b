// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nav_msgs/OccupancyGrid.h>
#include <tzc/array.h>
namespace tzc {
namespace nav_msgs {
struct OccupancyGrid {
  typedef ::nav_msgs::OccupancyGrid Stock;
  typedef boost::shared_ptr<OccupancyGrid> Ptr;
  typedef boost::shared_ptr<OccupancyGrid const> ConstPtr;
  OccupancyGrid() = default;
  explicit OccupancyGrid(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, OccupancyGrid&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  uint32_t height = 0, width = 0;
  typedef ::tzc::Array<int8_t> _data_type;
  _data_type data;
};
typedef boost::shared_ptr<OccupancyGrid> OccupancyGridPtr;
typedef boost::shared_ptr<OccupancyGrid const> OccupancyGridConstPtr;
inline std::ostream& operator<<(std::ostream& s, const OccupancyGrid&) {
  return s;
}
}  // namespace nav_msgs
}  // namespace tzc
