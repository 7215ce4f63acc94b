// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/Image.h>
#include <tzc/memory.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "pattern.h"

namespace tzc_test {

/// One line of JSON about an image: number, seq, whether the bytes are right, whether they lie in a shared
/// segment. `extra`: more members, each with a comma behind it.
inline void print_image(const sensor_msgs::Image& image, const std::string& extra = std::string()) {
  const auto number = static_cast<std::uint32_t>(std::atoi(image.header.frame_id.c_str()));
  const double latency = (ros::Time::now() - image.header.stamp).toSec() * 1e6;
  const bool right = has_pattern(image.data.data(), image.data.size(), number);
  const bool shared = tzc::in_segment(image.data.data());
  std::printf("{%s\"number\": %u, \"seq\": %u, \"right\": %s, \"shared\": %s, \"latency_us\": %.1f}\n",
              extra.c_str(), number, image.header.seq, right ? "true" : "false", shared ? "true" : "false",
              latency);
  std::fflush(stdout);
}

template <class Image>
void fill_image(Image& image, std::uint32_t number, std::size_t bytes) {
  image.header.frame_id = std::to_string(number);
  image.height = 1;
  image.width = static_cast<std::uint32_t>(bytes);
  image.step = image.width;
  image.encoding = "mono8";
  image.data.resize(bytes);
  fill_pattern(image.data.data(), bytes, number);
  image.header.stamp = ros::Time::now();
}

}  // namespace tzc_test
