// SPDX-License-Identifier: BSD-3-Clause
// A topic's message with the name of a part of a service.
#pragma once
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct ScanRequest_ {
  std::vector<uint8_t> data;
  FAKE_MEMBERS(ScanRequest_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, ScanRequest)
