// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct Image_ {
  std_msgs::Header header;
  uint32_t height = 0, width = 0;
  std::string encoding;
  uint8_t is_bigendian = 0;
  uint32_t step = 0;
  std::vector<uint8_t> data;
  FAKE_MEMBERS(Image_)
};
template <class A, class B>
bool operator==(const Image_<A>& a, const Image_<B>& b) {
  return a.data == b.data;
}
template <class A, class B>
bool operator!=(const Image_<A>& a, const Image_<B>& b) {
  return !(a == b);
}
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, Image)
