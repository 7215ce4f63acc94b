// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/PointField.h>
#include <std_msgs/Header.h>
namespace sensor_msgs {
template <class A>
struct PointCloud2_ {
  std_msgs::Header header;
  uint32_t height = 0, width = 0;
  std::vector<sensor_msgs::PointField> fields;
  uint32_t point_step = 0, row_step = 0;
  std::vector<uint8_t> data;
  uint8_t is_dense = 0;
  FAKE_MEMBERS(PointCloud2_)
};
}  // namespace sensor_msgs
FAKE_MESSAGE(sensor_msgs, PointCloud2)
