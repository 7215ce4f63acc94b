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
}  // namespace cv_bridge
}  // namespace tzc
