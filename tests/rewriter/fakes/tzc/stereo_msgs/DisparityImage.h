// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stereo_msgs/DisparityImage.h>
#include <tzc/array.h>
#include <tzc/sensor_msgs/Image.h>
namespace tzc {
namespace stereo_msgs {
struct DisparityImage {
  typedef ::stereo_msgs::DisparityImage Stock;
  typedef boost::shared_ptr<DisparityImage> Ptr;
  typedef boost::shared_ptr<DisparityImage const> ConstPtr;
  DisparityImage() = default;
  explicit DisparityImage(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, DisparityImage&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  ::tzc::sensor_msgs::Image image;
  float f = 0;
};
typedef boost::shared_ptr<DisparityImage> DisparityImagePtr;
typedef boost::shared_ptr<DisparityImage const> DisparityImageConstPtr;
inline std::ostream& operator<<(std::ostream& s, const DisparityImage&) {
  return s;
}
}  // namespace stereo_msgs
}  // namespace tzc
