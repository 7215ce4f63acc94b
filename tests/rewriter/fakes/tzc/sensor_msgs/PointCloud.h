// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/PointCloud.h>
#include <tzc/array.h>
#include <tzc/message_array.h>
#include <tzc/sensor_msgs/ChannelFloat32.h>
namespace tzc {
namespace sensor_msgs {
struct PointCloud {
  typedef ::sensor_msgs::PointCloud Stock;
  typedef boost::shared_ptr<PointCloud> Ptr;
  typedef boost::shared_ptr<PointCloud const> ConstPtr;
  PointCloud() = default;
  explicit PointCloud(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, PointCloud&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  ::tzc::Array<::geometry_msgs::Point> points;
  typedef ::tzc::MessageArray<ChannelFloat32> _channels_type;
  _channels_type channels;
};
typedef boost::shared_ptr<PointCloud> PointCloudPtr;
typedef boost::shared_ptr<PointCloud const> PointCloudConstPtr;
inline std::ostream& operator<<(std::ostream& s, const PointCloud&) {
  return s;
}
}  // namespace sensor_msgs
}  // namespace tzc
