// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/Image.h>
#include <std_msgs/Header.h>
namespace stereo_msgs {
template <class A>
struct DisparityImage_ {
  std_msgs::Header header;
  sensor_msgs::Image image;
  float f = 0;
  FAKE_MEMBERS(DisparityImage_)
};
}  // namespace stereo_msgs
FAKE_MESSAGE(stereo_msgs, DisparityImage)
