// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/Image.h>
#include <tzc/array.h>
namespace tzc {
namespace sensor_msgs {
struct Image {
  typedef ::sensor_msgs::Image Stock;
  typedef boost::shared_ptr<Image> Ptr;
  typedef boost::shared_ptr<Image const> ConstPtr;
  Image() = default;
  explicit Image(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, Image&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  uint32_t height = 0, width = 0;
  std::string encoding;
  uint8_t is_bigendian = 0;
  uint32_t step = 0;
  ::tzc::Array<uint8_t> data;
};
inline bool operator==(const Image& a, const Image::Stock& b) {
  return a.width == b.width;
}
inline bool operator==(const Image::Stock& a, const Image& b) {
  return b == a;
}
inline bool operator!=(const Image& a, const Image::Stock& b) {
  return !(a == b);
}
inline bool operator!=(const Image::Stock& a, const Image& b) {
  return !(b == a);
}
inline bool operator==(const Image& a, const Image& b) {
  return a.width == b.width;
}
typedef boost::shared_ptr<Image> ImagePtr;
typedef boost::shared_ptr<Image const> ImageConstPtr;
inline std::ostream& operator<<(std::ostream& s, const Image&) {
  return s;
}
}  // namespace sensor_msgs
}  // namespace tzc
