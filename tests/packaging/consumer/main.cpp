// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <cstdio>

int main() {
  tzc::Publisher publisher;
  tzc::sensor_msgs::Image image;
  image.data.resize(3);
  std::printf("%zu bytes, %s\n", image.data.size(),
              publisher.allocate(image) ? "allocated" : "not allocated");
}
