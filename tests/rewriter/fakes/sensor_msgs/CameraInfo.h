// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct CameraInfo_ {
  std_msgs::Header header;
  uint32_t height = 0, width = 0;
  std::string distortion_model;
  std::vector<double> D;
  boost::array<double, 9> K;
  FAKE_MEMBERS(CameraInfo_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, CameraInfo)
