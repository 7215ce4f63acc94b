// SPDX-License-Identifier: BSD-3-Clause
// cv_bridge for tzc:: messages: the one copy that the library makes anyway puts an image into shared memory.
// Header-only; link cv_bridge as before.
#pragma once

#include <tzc/memory.h>
#include <tzc/sensor_msgs/Image.h>

#include <cv_bridge/cv_bridge.h>
#include <sensor_msgs/image_encodings.h>

#include <boost/make_shared.hpp>
#include <boost/shared_ptr.hpp>

#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <utility>

namespace tzc {
namespace cv_bridge {

namespace detail {

inline bool is_big_endian() {
  const std::uint16_t one = 1;
  std::uint8_t first;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

inline void copy_rows(const cv::Mat& from, std::size_t row_size, std::uint8_t* to) {
  if (from.isContinuous()) {
    std::memcpy(to, from.data, row_size * from.rows);
    return;
  }
  for (int row = 0; row < from.rows; ++row) std::memcpy(to + row * row_size, from.ptr(row), row_size);
}

/// Over `pixels`, which are the message's.
inline cv::Mat mat_of(const sensor_msgs::Image& message, std::uint8_t* pixels) {
  const int type = ::cv_bridge::getCvType(message.encoding);
  const std::uint64_t row_size = static_cast<std::uint64_t>(CV_ELEM_SIZE(type)) * message.width;
  const std::uint64_t size = std::uint64_t{message.step} * message.height;
  if (message.step < row_size || message.data.size() < size) {
    throw ::cv_bridge::Exception(
        "tzc::cv_bridge::mat: step or data is smaller than width, height and encoding need");
  }
  return cv::Mat(static_cast<int>(message.height), static_cast<int>(message.width), type, pixels,
                 message.step);
}

}  // namespace detail

/// CvImage::toImageMsg(message) for a tzc:: message: the same content, one copy of the pixels. The pixels go
/// into shared memory when the message is allocated or bound.
inline void to_image_msg(const ::cv_bridge::CvImage& image, sensor_msgs::Image& message) {
  const std::size_t row_size = image.image.cols * image.image.elemSize();
  message.header = image.header;
  message.height = image.image.rows;
  message.width = image.image.cols;
  message.encoding = image.encoding;
  message.is_bigendian = detail::is_big_endian();
  message.step = static_cast<std::uint32_t>(row_size);
  message.data.resize(row_size * image.image.rows, uninitialized);
  if (!message.data.empty()) detail::copy_rows(image.image, row_size, message.data.data());
}

/// CvImage::toImageMsg() into `memory`: one copy, after which publishing copies nothing. When the memory is
/// exhausted the pixels go to the heap, and publishing tries again.
inline sensor_msgs::ImagePtr to_image_msg(const ::cv_bridge::CvImage& image,
                                          std::shared_ptr<MemorySource> memory) {
  const sensor_msgs::ImagePtr message = boost::make_shared<sensor_msgs::Image>();
  message->data.bind(std::move(memory));
  to_image_msg(image, *message);
  return message;
}

/// CvImage::toImageMsg() into the memory of a publisher, anything with memory().
template <class Publisher>
auto to_image_msg(const ::cv_bridge::CvImage& image, const Publisher& publisher)
    -> decltype(publisher.memory(), sensor_msgs::ImagePtr()) {
  return to_image_msg(image, std::shared_ptr<MemorySource>(publisher.memory()));
}
/// The same for CvImagePtr and CvImageConstPtr.
template <class Image, class Target>
auto to_image_msg(const boost::shared_ptr<Image>& image, Target&& target)
    -> decltype(to_image_msg(*image, std::forward<Target>(target))) {
  return to_image_msg(*image, std::forward<Target>(target));
}

namespace detail {

/// Without a copy of the pixels; throws as mat() does.
inline ::cv_bridge::CvImagePtr view_of(const sensor_msgs::Image& message) {
  const cv::Mat pixels = mat_of(message, const_cast<std::uint8_t*>(message.data.data()));
  return boost::make_shared< ::cv_bridge::CvImage>(message.header, message.encoding, pixels);
}

}  // namespace detail

/// cv_bridge::toCvCopy for tzc:: messages: one copy of the pixels, in the encoding that is asked for; "": in their own. Reads the message
/// alone, which may be published. Throws cv_bridge::Exception where the library does.
inline ::cv_bridge::CvImagePtr toCvCopy(const sensor_msgs::Image& message,
                                        const std::string& encoding = std::string()) {
  const bool swaps_bytes = message.is_bigendian != detail::is_big_endian() &&
                           ::sensor_msgs::image_encodings::bitDepth(message.encoding) > 8;
  if (swaps_bytes) return ::cv_bridge::toCvCopy(static_cast< ::sensor_msgs::Image>(message), encoding);
  return ::cv_bridge::cvtColor(detail::view_of(message), encoding);
}
/// The same for a pointer to one.
template <class Image>
auto toCvCopy(const boost::shared_ptr<Image>& message, const std::string& encoding = std::string())
    -> decltype(toCvCopy(*message, encoding)) {
  return toCvCopy(*message, encoding);
}

/// A matrix over the pixels of `message`, for drawing in place without a copy. Set height, width, encoding
/// and step, and resize data first. Publishing, resizing or destroying the message invalidates the matrix.
/// Throws cv_bridge::Exception when the encoding has no OpenCV type, or data is smaller than height × step
/// bytes.
inline cv::Mat mat(sensor_msgs::Image& message) {
  return detail::mat_of(message, message.data.data());
}

}  // namespace cv_bridge
}  // namespace tzc
