// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <tzc/array.h>
#include <tzc/message_array.h>
#include <tzc/visualization_msgs/Marker.h>
#include <visualization_msgs/MarkerArray.h>
namespace tzc {
namespace visualization_msgs {
struct MarkerArray {
  typedef ::visualization_msgs::MarkerArray Stock;
  typedef boost::shared_ptr<MarkerArray> Ptr;
  typedef boost::shared_ptr<MarkerArray const> ConstPtr;
  MarkerArray() = default;
  explicit MarkerArray(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, MarkerArray&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  typedef ::tzc::MessageArray< ::tzc::visualization_msgs::Marker> _markers_type;
  _markers_type markers;
};
typedef boost::shared_ptr<MarkerArray> MarkerArrayPtr;
typedef boost::shared_ptr<MarkerArray const> MarkerArrayConstPtr;
inline std::ostream& operator<<(std::ostream& s, const MarkerArray&) {
  return s;
}
}  // namespace visualization_msgs
}  // namespace tzc
