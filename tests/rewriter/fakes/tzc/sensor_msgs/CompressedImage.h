// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/CompressedImage.h>
#include <tzc/array.h>
namespace tzc {
namespace sensor_msgs {
struct CompressedImage {
  typedef ::sensor_msgs::CompressedImage Stock;
  typedef boost::shared_ptr<CompressedImage> Ptr;
  typedef boost::shared_ptr<CompressedImage const> ConstPtr;
  CompressedImage() = default;
  explicit CompressedImage(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, CompressedImage&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  std::string format;
  ::tzc::Array<uint8_t> data;
};
typedef boost::shared_ptr<CompressedImage> CompressedImagePtr;
typedef boost::shared_ptr<CompressedImage const> CompressedImageConstPtr;
inline std::ostream& operator<<(std::ostream& s, const CompressedImage&) {
  return s;
}
}  // namespace sensor_msgs
}  // namespace tzc
