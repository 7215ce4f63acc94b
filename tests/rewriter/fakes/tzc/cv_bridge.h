// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cv_bridge/cv_bridge.h>
#include <tzc/sensor_msgs/Image.h>
namespace tzc {
namespace cv_bridge {
template <class P>
sensor_msgs::ImagePtr to_image_msg(const ::cv_bridge::CvImage&, const P&) {
  return {};
}
inline void to_image_msg(const ::cv_bridge::CvImage&, sensor_msgs::Image&) {}
inline ::cv_bridge::CvImagePtr toCvCopy(const sensor_msgs::Image&, const std::string& = "") {
  return {};
}
template <class Image>
auto toCvCopy(const boost::shared_ptr<Image>& image, const std::string& encoding = "")
    -> decltype(toCvCopy(*image, encoding)) {
  return {};
}
}  // namespace cv_bridge
}  // namespace tzc
