// SPDX-License-Identifier: BSD-3-Clause
// The helpers of sensor_msgs for tzc:: messages: fillImage, clearImage, PointCloud2Modifier and the point
// iterators. They behave like sensor_msgs' own.
#pragma once

#include <tzc/detail/point_cloud2_modifier.h>
#include <tzc/detail/vector_words.h>
#include <tzc/sensor_msgs/Image.h>
#include <tzc/sensor_msgs/PointCloud2.h>

#include <sensor_msgs/point_cloud2_iterator.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace tzc {
namespace sensor_msgs {

/// sensor_msgs::fillImage. Its one copy goes into shared memory when the image is bound or allocated.
inline bool fillImage(Image& image, const std::string& encoding, std::uint32_t rows, std::uint32_t columns,
                      std::uint32_t step, const void* pixels) {
  image.encoding = encoding;
  image.height = rows;
  image.width = columns;
  image.step = step;
  image.is_bigendian = 0;
  const std::size_t size = step * rows;
  image.data.resize(size, uninitialized);
  if (size != 0) std::memcpy(image.data.data(), pixels, size);
  return true;
}

/// sensor_msgs::clearImage.
inline void clearImage(Image& image) {
  image.data.clear();
}

namespace detail {

/// A stock cloud that has the fields of a tzc:: cloud, as long as it lives.
class LentFields {
 public:
  explicit LentFields(PointCloud2& cloud) : cloud_(cloud) { stock_.fields.swap(cloud_.fields); }
  LentFields(const LentFields&) = delete;
  LentFields& operator=(const LentFields&) = delete;
  ~LentFields() { stock_.fields.swap(cloud_.fields); }

  ::sensor_msgs::PointCloud2& stock() { return stock_; }

 private:
  PointCloud2& cloud_;
  ::sensor_msgs::PointCloud2 stock_;
};

/// A stock cloud that borrows the data of a tzc:: cloud, and copies its fields. The tzc:: cloud must outlive
/// it.
class BorrowedCloud {
 public:
  /// `data`: the first byte of cloud.data, writable if the iterator is to write.
  BorrowedCloud(const PointCloud2& cloud, const std::uint8_t* data) {
    static_assert(tzc::detail::HasVectorWords<std::vector<std::uint8_t> >::value,
                  "point iterators need a std::vector that consists of three pointers");
    stock_.is_bigendian = cloud.is_bigendian;
    stock_.point_step = cloud.point_step;
    stock_.fields = cloud.fields;
    std::uint8_t* const begin = const_cast<std::uint8_t*>(data);
    tzc::detail::VectorWords{begin, begin + cloud.data.size(), begin + cloud.data.size()}.write_to(
        &stock_.data);
  }
  BorrowedCloud(const BorrowedCloud&) = delete;
  BorrowedCloud& operator=(const BorrowedCloud&) = delete;
  ~BorrowedCloud() { tzc::detail::VectorWords::clear(&stock_.data); }

  ::sensor_msgs::PointCloud2& stock() { return stock_; }

 private:
  ::sensor_msgs::PointCloud2 stock_;
};

}  // namespace detail

/// addPointField of <sensor_msgs/point_cloud2_iterator.h>: returns the offset of the next field. Throws std::runtime_error for an unknown
/// datatype, and has added the field then.
inline int addPointField(PointCloud2& cloud, const std::string& name, int count, int datatype, int offset) {
  return ::addPointField(detail::LentFields(cloud).stock(), name, count, datatype, offset);
}

/// sensor_msgs::PointCloud2Iterator over a tzc:: cloud. Derives from it, so it can be passed as one.
template <class T>
class PointCloud2Iterator : public ::sensor_msgs::PointCloud2Iterator<T> {
  using Base = ::sensor_msgs::PointCloud2Iterator<T>;

 public:
  /// Throws std::runtime_error when the cloud has no such field.
  PointCloud2Iterator(PointCloud2& cloud, const std::string& field)
      : Base(detail::BorrowedCloud(cloud, cloud.data.data()).stock(), field) {}
  PointCloud2Iterator(const Base& iterator) : Base(iterator) {}  // NOLINT: what + and end() return
};

/// sensor_msgs::PointCloud2ConstIterator over a tzc:: cloud.
template <class T>
class PointCloud2ConstIterator : public ::sensor_msgs::PointCloud2ConstIterator<T> {
  using Base = ::sensor_msgs::PointCloud2ConstIterator<T>;

 public:
  /// Throws std::runtime_error when the cloud has no such field.
  PointCloud2ConstIterator(const PointCloud2& cloud, const std::string& field)
      : Base(detail::BorrowedCloud(cloud, cloud.data.data()).stock(), field) {}
  PointCloud2ConstIterator(const Base& iterator) : Base(iterator) {}  // NOLINT: what + and end() return
};

}  // namespace sensor_msgs
}  // namespace tzc
