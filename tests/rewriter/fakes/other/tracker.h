// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
namespace other {
class Tracker {
 public:
  void on_image(const sensor_msgs::ImageConstPtr& image);
};
}  // namespace other
