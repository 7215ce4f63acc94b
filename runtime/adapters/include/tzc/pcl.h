// SPDX-License-Identifier: BSD-3-Clause
// PCL for tzc:: messages: toROSMsg, fromPCL, moveFromPCL (also for pcl_msgs), and publishing
// pcl::PointCloud<T> itself. Header-only; link PCL as before. Publishing pcl::PointCloud<T> also needs
// <pcl_ros/point_cloud.h>, as with roscpp.
#pragma once

#include <tzc/detail/pcl_codec.h>
#include <tzc/sensor_msgs/Image.h>
#include <tzc/sensor_msgs/PointCloud2.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl_conversions/pcl_conversions.h>

#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

namespace tzc {
namespace pcl_conversions {

namespace detail {

template <class From, class To>
void copy_shape(const From& from, To& to) {
  to.height = from.height;
  to.width = from.width;
  to.is_bigendian = from.is_bigendian;
  to.point_step = from.point_step;
  to.row_step = from.row_step;
  to.is_dense = from.is_dense;
}

inline void copy_meta_data(const ::pcl::PCLPointCloud2& from, sensor_msgs::PointCloud2& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  ::pcl_conversions::fromPCL(from.fields, to.fields);
  copy_shape(from, to);
}

inline void copy_meta_data(const sensor_msgs::PointCloud2& from, ::pcl::PCLPointCloud2& to) {
  ::pcl_conversions::toPCL(from.header, to.header);
  ::pcl_conversions::toPCL(from.fields, to.fields);
  copy_shape(from, to);
}

inline void copy_meta_data(const ::pcl::PCLImage& from, sensor_msgs::Image& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  to.height = from.height;
  to.width = from.width;
  to.encoding = from.encoding;
  to.is_bigendian = from.is_bigendian;
  to.step = from.step;
}

/// Copies what the message had, so that its memory stays its own.
template <class T>
void exchange(std::vector<T>& from, Array<T>& to) {
  std::vector<T> before(to.cbegin(), to.cend());
  to = std::move(from);
  from = std::move(before);
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

/// pcl_conversions::moveFromPCL for tzc:: messages. Moves the data; publishing copies it once. If the message
/// already has shared memory for it, the copy happens here. As in the library, `from` gets the message's data of before.
inline void moveFromPCL(::pcl::PCLPointCloud2& from, sensor_msgs::PointCloud2& to) {
  detail::copy_meta_data(from, to);
  detail::exchange(from.data, to.data);
}
inline void moveFromPCL(::pcl::PCLImage& from, sensor_msgs::Image& to) {
  detail::copy_meta_data(from, to);
  detail::exchange(from.data, to.data);
}

}  // namespace pcl_conversions
}  // namespace tzc

#if __has_include(<tzc/pcl_msgs/PolygonMesh.h>)
#include <tzc/detail/pcl_msgs.h>
#endif

namespace tzc {
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

/// pcl::fromROSMsg for tzc:: messages: the cloud's own copy of the points, as the library makes. Reads the message alone, which may be
/// published.
template <class Point>
void fromROSMsg(const sensor_msgs::PointCloud2& message, ::pcl::PointCloud<Point>& cloud) {
  ::pcl::PCLPointCloud2 description;
  pcl_conversions::detail::copy_meta_data(message, description);
  const message::detail::BorrowedData data(description.data, {message.data.data(), message.data.size()});
  ::pcl::fromPCLPointCloud2(description, cloud);
}

namespace detail {

/// Where the color of the first point lies. Throws as pcl::toPCLPointCloud2 does.
inline const std::uint8_t* first_color(const ::sensor_msgs::PointCloud2& cloud) {
  const int field = ::pcl::getFieldIndex(cloud, "rgb");
  if (field < 0) throw std::runtime_error("No rgb field!!");
  if (cloud.width == 0 && cloud.height == 0) throw std::runtime_error("Needs to be a dense like cloud!!");
  const std::uint64_t points = std::uint64_t{cloud.width} * cloud.height;
  const std::uint64_t first = cloud.fields[static_cast<std::size_t>(field)].offset;
  if (points != 0 && first + (points - 1) * cloud.point_step + 3 > cloud.data.size())
    throw std::runtime_error("The width and height do not match the cloud size!");
  return cloud.data.data() + first;
}

/// `color`: of the first of width × height points, `stride` bytes apart.
inline void fill_color(std::uint32_t width, std::uint32_t height, const std::uint8_t* color,
                       std::size_t stride, sensor_msgs::Image& image) {
  const std::size_t pixel_size = 3, pixels = std::size_t{width} * height;
  image.height = height;
  image.width = width;
  image.encoding = "bgr8";
  image.step = static_cast<std::uint32_t>(pixel_size * width);
  image.data.resize(pixels * pixel_size, uninitialized);
  std::uint8_t* const data = image.data.data();
  for (std::size_t i = 0; i < pixels; ++i) std::memcpy(data + i * pixel_size, color + i * stride, pixel_size);
}

}  // namespace detail

/// pcl::toROSMsg of a cloud's color for tzc:: images: one copy, of the color alone. Throws std::runtime_error
/// when there is no field "rgb" or no shape.
inline void toROSMsg(const ::sensor_msgs::PointCloud2& cloud, sensor_msgs::Image& image) {
  detail::fill_color(cloud.width, cloud.height, detail::first_color(cloud), cloud.point_step, image);
  image.header =
      ::pcl_conversions::fromPCL(::pcl_conversions::toPCL(cloud.header));  // rounds the stamp to µs
  image.is_bigendian = 0;
}
/// pcl::moveToROSMsg: empties the cloud's data.
inline void moveToROSMsg(::sensor_msgs::PointCloud2& cloud, sensor_msgs::Image& image) {
  toROSMsg(static_cast<const ::sensor_msgs::PointCloud2&>(cloud), image);
  std::vector<std::uint8_t>().swap(cloud.data);
}
/// The color of a cloud of points, with one copy. Leaves header and is_bigendian as they are, as the library
/// does.
template <class Point>
void toROSMsg(const ::pcl::PointCloud<Point>& cloud, sensor_msgs::Image& image) {
  if (cloud.width == 0 && cloud.height == 0) throw std::runtime_error("Needs to be a dense like cloud!!");
  if (cloud.points.size() != std::size_t{cloud.width} * cloud.height)
    throw std::runtime_error("The width and height do not match the cloud size!");
  const auto* const color =
      cloud.points.empty() ? nullptr : reinterpret_cast<const std::uint8_t*>(&cloud.points[0].rgb);
  detail::fill_color(cloud.width, cloud.height, color, sizeof(Point), image);
}

}  // namespace pcl
}  // namespace tzc
