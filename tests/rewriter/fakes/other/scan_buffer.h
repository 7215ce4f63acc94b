// SPDX-License-Identifier: BSD-3-Clause
// A library that keeps messages.
#pragma once
#include <sensor_msgs/LaserScan.h>
namespace other {
class ScanBuffer {
 public:
  const sensor_msgs::LaserScan& latest() const { return latest_; }

 private:
  sensor_msgs::LaserScan latest_;
};
}  // namespace other
