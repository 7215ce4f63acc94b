// SPDX-License-Identifier: BSD-3-Clause
// PCL for tzc:: messages: toROSMsg, fromPCL, moveFromPCL, and clouds that are published as such.
// Header-only; link PCL as before. Publishing pcl::PointCloud<T> also needs <pcl_ros/point_cloud.h>, as with
// roscpp.
#pragma once

#include <tzc/detail/pcl_codec.h>
#include <tzc/sensor_msgs/Image.h>
#include <tzc/sensor_msgs/PointCloud2.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl_conversions/pcl_conversions.h>

#include <cstring>
#include <utility>

namespace tzc {
namespace pcl_conversions {

namespace detail {

inline void copy_meta_data(const ::pcl::PCLPointCloud2& from, sensor_msgs::PointCloud2& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  to.height = from.height;
  to.width = from.width;
  ::pcl_conversions::fromPCL(from.fields, to.fields);
  to.is_bigendian = from.is_bigendian;
  to.point_step = from.point_step;
  to.row_step = from.row_step;
  to.is_dense = from.is_dense;
}

inline void copy_meta_data(const ::pcl::PCLImage& from, sensor_msgs::Image& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  to.height = from.height;
  to.width = from.width;
  to.encoding = from.encoding;
  to.is_bigendian = from.is_bigendian;
  to.step = from.step;
}

}  // namespace detail

/// pcl_conversions::fromPCL for tzc:: messages: one copy of the data, into shared memory when `to` is bound.
inline void fromPCL(const ::pcl::PCLPointCloud2& from, sensor_msgs::PointCloud2& to) {
  detail::copy_meta_data(from, to);
  to.data = from.data;
}
inline void fromPCL(const ::pcl::PCLImage& from, sensor_msgs::Image& to) {
  detail::copy_meta_data(from, to);
  to.data = from.data;
}

/// pcl_conversions::moveFromPCL for tzc:: messages. Takes the data over; publishing copies it once. If the
/// message has shared memory for it already, that copy is made here.
inline void moveFromPCL(::pcl::PCLPointCloud2& from, sensor_msgs::PointCloud2& to) {
  detail::copy_meta_data(from, to);
  to.data = std::move(from.data);
}
inline void moveFromPCL(::pcl::PCLImage& from, sensor_msgs::Image& to) {
  detail::copy_meta_data(from, to);
  to.data = std::move(from.data);
}

}  // namespace pcl_conversions

namespace pcl {

/// pcl::toROSMsg for tzc:: messages: one copy of the points, into shared memory when `message` is bound or
/// allocated.
template <class Point>
void toROSMsg(const ::pcl::PointCloud<Point>& cloud, sensor_msgs::PointCloud2& message) {
  pcl_conversions::detail::copy_meta_data(message::detail::describe(cloud), message);
  const std::size_t size = cloud.points.size() * sizeof(Point);
  message.data.resize(size, uninitialized);
  if (size != 0) std::memcpy(message.data.data(), cloud.points.data(), size);
}

}  // namespace pcl
}  // namespace tzc
