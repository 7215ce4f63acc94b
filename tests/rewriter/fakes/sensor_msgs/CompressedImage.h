// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct CompressedImage_ {
  std_msgs::Header header;
  std::string format;
  std::vector<uint8_t> data;
  FAKE_MEMBERS(CompressedImage_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, CompressedImage)
