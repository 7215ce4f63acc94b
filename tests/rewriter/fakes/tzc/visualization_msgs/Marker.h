// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <tzc/array.h>
#include <visualization_msgs/Marker.h>
namespace tzc {
namespace visualization_msgs {
struct Marker {
  typedef ::visualization_msgs::Marker Stock;
  typedef boost::shared_ptr<Marker> Ptr;
  typedef boost::shared_ptr<Marker const> ConstPtr;
  Marker() = default;
  explicit Marker(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, Marker&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  int type = 0;
  std::string text;
  ::tzc::Array<::geometry_msgs::Point> points;
};
typedef boost::shared_ptr<Marker> MarkerPtr;
typedef boost::shared_ptr<Marker const> MarkerConstPtr;
inline std::ostream& operator<<(std::ostream& s, const Marker&) {
  return s;
}
}  // namespace visualization_msgs
}  // namespace tzc
