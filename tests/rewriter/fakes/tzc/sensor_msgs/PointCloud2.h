// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/PointCloud2.h>
#include <tzc/array.h>
namespace tzc {
namespace sensor_msgs {
struct PointCloud2 {
  typedef ::sensor_msgs::PointCloud2 Stock;
  typedef boost::shared_ptr<PointCloud2> Ptr;
  typedef boost::shared_ptr<PointCloud2 const> ConstPtr;
  PointCloud2() = default;
  explicit PointCloud2(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, PointCloud2&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  uint32_t height = 0, width = 0;
  std::vector<::sensor_msgs::PointField> fields;
  uint32_t point_step = 0, row_step = 0;
  ::tzc::Array<uint8_t> data;
  uint8_t is_dense = 0;
};
typedef boost::shared_ptr<PointCloud2> PointCloud2Ptr;
typedef boost::shared_ptr<PointCloud2 const> PointCloud2ConstPtr;
inline std::ostream& operator<<(std::ostream& s, const PointCloud2&) {
  return s;
}
}  // namespace sensor_msgs
}  // namespace tzc
