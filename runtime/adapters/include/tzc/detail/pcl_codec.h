// SPDX-License-Identifier: BSD-3-Clause
// The partial form of pcl::PointCloud and pcl::PCLPointCloud2: that of sensor_msgs/PointCloud2. Include
// <tzc/pcl.h>.
#pragma once

#include <tzc/detail/vector_words.h>
#include <tzc/message.h>

#include <pcl/conversions.h>
#include <pcl/point_cloud.h>
#include <pcl_conversions/pcl_conversions.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstdint>

namespace tzc {
namespace message {

template <>
struct Traits< ::pcl::PCLPointCloud2> {
  typedef ::sensor_msgs::PointCloud2 Stock;
  template <class Message, class Visitor>
  static void visit_data(Message&, Visitor&&) {}
  template <class Message, class Visitor>
  static void visit_message_arrays(Message&, Visitor&&) {}
};
template <class Point>
struct Traits< ::pcl::PointCloud<Point> > : Traits< ::pcl::PCLPointCloud2> {};

namespace detail {

/// Everything but the data of the message that PCL makes of a cloud.
template <class Point>
::pcl::PCLPointCloud2 describe(const ::pcl::PointCloud<Point>& cloud) {
  ::pcl::PCLPointCloud2 description;
  ::pcl::toPCLPointCloud2(::pcl::PointCloud<Point>(), description);
  const bool has_shape = cloud.width != 0 || cloud.height != 0;
  description.header = cloud.header;
  description.height = has_shape ? cloud.height : 1;
  description.width = has_shape ? cloud.width : static_cast<std::uint32_t>(cloud.points.size());
  description.row_step = description.point_step * description.width;
  description.is_dense = cloud.is_dense;
  return description;
}

/// Sets `used` to the bytes that the points of a received cloud take. False: a field of a point lies outside of them, so
/// that PCL could not read it safely. The step of a single row means nothing, and some programs leave it out.
inline bool find_points(const ::pcl::PCLPointCloud2& cloud, std::size_t available, std::size_t& used) {
  const std::uint64_t row = std::uint64_t{cloud.width} * cloud.point_step;
  const bool is_one_row = cloud.height <= 1;
  const std::uint64_t size = cloud.height * (is_one_row ? row : std::uint64_t{cloud.row_step});
  used = static_cast<std::size_t>(size);
  if (cloud.point_step == 0) return cloud.width == 0 || cloud.height == 0;
  if ((!is_one_row && row > cloud.row_step) || size > available) return false;
  for (const auto& field : cloud.fields) {
    const std::uint64_t element = ::pcl::getFieldSize(field.datatype);
    if (field.offset + element * field.count > cloud.point_step) return false;
  }
  return true;
}

/// The data of a PCLPointCloud2 that lies in a block.
class BorrowedData {
 public:
  BorrowedData(std::vector<std::uint8_t>& data, const DataArray& array) : data_(data) {
    if (tzc::detail::can_use_vector_words<std::vector<std::uint8_t> >()) {
      std::uint8_t* const begin = const_cast<std::uint8_t*>(array.data);
      tzc::detail::VectorWords{begin, begin + array.count, begin + array.count}.write_to(&data_);
    } else {
      data_.assign(array.data, array.data + array.count);
    }
  }
  BorrowedData(const BorrowedData&) = delete;
  BorrowedData& operator=(const BorrowedData&) = delete;
  ~BorrowedData() {
    if (tzc::detail::can_use_vector_words<std::vector<std::uint8_t> >())
      tzc::detail::VectorWords::clear(&data_);
  }

 private:
  std::vector<std::uint8_t>& data_;
};

}  // namespace detail

/// Clouds of points: written and read with one copy of the points, like any data array that is not in shared
/// memory.
template <class Point>
struct Codec< ::pcl::PointCloud<Point> > {
  template <class Stream>
  static void write(Stream& stream, const ::pcl::PointCloud<Point>& cloud) {
    const ::pcl::PCLPointCloud2 description = detail::describe(cloud);
    ::std_msgs::Header header;
    ::pcl_conversions::fromPCL(description.header, header);
    std::vector< ::sensor_msgs::PointField> fields;
    ::pcl_conversions::fromPCL(description.fields, fields);
    stream.next(header);
    stream.next(description.height);
    stream.next(description.width);
    stream.next(fields);
    stream.next(description.is_bigendian);
    stream.next(description.point_step);
    stream.next(description.row_step);
    stream.next_array(cloud.points.data(), cloud.points.size() * sizeof(Point), 1);
    stream.next(description.is_dense);
  }

  template <class Stream>
  static void read(Stream& stream, ::pcl::PointCloud<Point>& cloud) {
    ::pcl::PCLPointCloud2 message;
    ::std_msgs::Header header;
    std::vector< ::sensor_msgs::PointField> fields;
    stream.next(header);
    stream.next(message.height);
    stream.next(message.width);
    stream.next(fields);
    stream.next(message.is_bigendian);
    stream.next(message.point_step);
    stream.next(message.row_step);
    detail::DataArray array = stream.next_array(1);
    stream.next(message.is_dense);
    ::pcl_conversions::toPCL(header, message.header);
    ::pcl_conversions::toPCL(fields, message.fields);
    // Of points that lie as in memory PCL copies all the data, whatever the shape: the rest of a larger array would not fit the cloud.
    if (!detail::find_points(message, array.count, array.count)) stream.throw_malformed();
    const detail::BorrowedData data(message.data, array);
    ::pcl::fromPCLPointCloud2(message, cloud);
  }
};

}  // namespace message
}  // namespace tzc
