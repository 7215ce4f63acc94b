// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/LaserScan.h>
#include <tzc/array.h>
namespace tzc {
namespace sensor_msgs {
struct LaserScan {
  typedef ::sensor_msgs::LaserScan Stock;
  typedef boost::shared_ptr<LaserScan> Ptr;
  typedef boost::shared_ptr<LaserScan const> ConstPtr;
  LaserScan() = default;
  explicit LaserScan(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, LaserScan&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  float angle_min = 0, angle_max = 0;
  ::tzc::Array<float> ranges;
  ::tzc::Array<float> intensities;
};
typedef boost::shared_ptr<LaserScan> LaserScanPtr;
typedef boost::shared_ptr<LaserScan const> LaserScanConstPtr;
inline std::ostream& operator<<(std::ostream& s, const LaserScan&) {
  return s;
}
}  // namespace sensor_msgs
}  // namespace tzc
