// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/Image.h>
namespace sensor_msgs {
inline bool fillImage(Image&, const std::string&, uint32_t, uint32_t, uint32_t, const void*) {
  return true;
}
inline void clearImage(Image&) {}
}  // namespace sensor_msgs
