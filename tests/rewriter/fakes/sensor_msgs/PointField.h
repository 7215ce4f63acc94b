// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct PointField_ {
  std::string name;
  uint32_t offset = 0;
  uint8_t datatype = 0;
  uint32_t count = 0;
  FAKE_MEMBERS(PointField_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, PointField)
