// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace std_msgs {
template <class A>
struct Float32MultiArray_ {
  std::vector<float> data;
  FAKE_MEMBERS(Float32MultiArray_)
};
}  // namespace std_msgs
FAKE_MESSAGE(std_msgs, Float32MultiArray)
