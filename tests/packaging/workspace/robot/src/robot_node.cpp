// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/robot_msgs/Readings.h>
#include <tzc/ros.h>

#include <cstdio>

int main() {
  tzc::Publisher publisher;
  tzc::robot_msgs::Readings readings;
  readings.values.resize(3);
  std::printf("%zu readings, %s\n", readings.values.size(),
              publisher.allocate(readings) ? "allocated" : "not allocated");
}
